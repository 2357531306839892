/* eigenmotion generate rigid_body.py */
/* input sha256:6a1fe9ffd82e911c66db48438e1fdf5de1dc79f32cda1ff870839cf9ae9e6072 */
/* body sha256:71085358a15eaf960a4d884bcf6e4aeaaaa084276c91aafd0b130d905bce8cbf */
/* rigid_body: 3 coordinates, 0 constraint rows, 18 states.
 * Link rigid_body.c with a program of your own, or import the Python module built from rigid_body.pyx. */
#ifndef EM_MODEL_rigid_body_H
#define EM_MODEL_rigid_body_H

#include "eigenmotion.h"

extern const em_model rigid_body_model;

#endif
