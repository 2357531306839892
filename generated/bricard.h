/* eigenmotion generate bricard.py */
/* input sha256:8bfed4695aa35d8d063cad4540c1a879bca63331457e2dff1caab598a87465d9 */
/* body sha256:6d62745e2b590e152ea0837984683a760f1543ed4a63f39bac6be8a166d8ec2c */
/* bricard: 5 coordinates, 4 constraint rows, 40 states.
 * Link bricard.c with a program of your own,
 * or import the Python module built from bricard.pyx. */
#ifndef EM_MODEL_bricard_H
#define EM_MODEL_bricard_H

#include "eigenmotion.h"

extern const em_model bricard_model;

#endif
