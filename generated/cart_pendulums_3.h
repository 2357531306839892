/* eigenmotion generate cart_pendulums.py */
/* input sha256:2166a7ac83f4a77333ace508537ee820c7acdbe8b322220d50204dc1a7bea13e */
/* body sha256:bca6cfcbf9861d8b9ed38df45df5713dccb6c06258efffeaaaf2bb8ced32e55e */
/* cart_pendulums_3: 4 coordinates, 0 constraint rows, 28 states.
 * Link cart_pendulums_3.c with a program of your own,
 * or import the Python module built from cart_pendulums_3.pyx. */
#ifndef EM_MODEL_cart_pendulums_3_H
#define EM_MODEL_cart_pendulums_3_H

#include "eigenmotion.h"

extern const em_model cart_pendulums_3_model;

#endif
