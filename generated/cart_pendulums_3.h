/* eigenmotion generate cart_pendulums.py */
/* input sha256:2166a7ac83f4a77333ace508537ee820c7acdbe8b322220d50204dc1a7bea13e */
/* body sha256:ff2f7c15cd561f8b76dca5aea2ea179d9b9782fb87ff8963dc08650150f08a94 */
/* cart_pendulums_3: 4 coordinates, 0 constraint rows, 28 states.
 * Link cart_pendulums_3.c with a program of your own, or import the Python module built from cart_pendulums_3.pyx. */
#ifndef EM_MODEL_cart_pendulums_3_H
#define EM_MODEL_cart_pendulums_3_H

#include "eigenmotion.h"

extern const em_model cart_pendulums_3_model;

#endif
