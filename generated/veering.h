/* eigenmotion generate veering.py */
/* input sha256:2e6e02de90e32e30ee3c86801410d8aa09018f181e6fefb7533073d61b039c6d */
/* body sha256:04066fda68a508cb46032d22c112c64e5a8540d9c6fd159e8373183702f4bef8 */
/* veering: 2 coordinates, 0 constraint rows, 10 states.
 * Link veering.c with a program of your own,
 * or import the Python module built from veering.pyx. */
#ifndef EM_MODEL_veering_H
#define EM_MODEL_veering_H

#include "eigenmotion.h"

/* Seen from outside of a library, whatever else it hides. */
__attribute__((visibility("default"))) extern const em_model veering_model;

#endif
