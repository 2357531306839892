/* eigenmotion generate cart_pendulums.py */
/* input sha256:2166a7ac83f4a77333ace508537ee820c7acdbe8b322220d50204dc1a7bea13e */
/* body sha256:f51ba5ea5d179e292fea6f3de5457b8e63f4a71f8e7abe7c1bce9a7b5dd6206b */
/* cart_pendulums_3: 4 coordinates, 0 constraint rows, 28 states.
 * Link cart_pendulums_3.c with a program of your own,
 * or import the Python module built from cart_pendulums_3.pyx. */
#ifndef EM_MODEL_cart_pendulums_3_H
#define EM_MODEL_cart_pendulums_3_H

#include "eigenmotion.h"

/* Seen from outside of a library, whatever else it hides. */
__attribute__((visibility("default"))) extern const em_model cart_pendulums_3_model;

#endif
