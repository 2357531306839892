/* eigenmotion generate veering.py */
/* input sha256:2e6e02de90e32e30ee3c86801410d8aa09018f181e6fefb7533073d61b039c6d */
/* body sha256:b847fe4ae6e6fd41c518c63e0eb6621c073e52bd9f2edc274c4e595ce3c00569 */
/* veering: 2 coordinates, 0 constraint rows, 10 states.
 * Link veering.c with a program of your own,
 * or import the Python module built from veering.pyx. */
#ifndef EM_MODEL_veering_H
#define EM_MODEL_veering_H

#include "eigenmotion.h"

extern const em_model veering_model;

#endif
