/* eigenmotion generate rigid_body.py */
/* input sha256:8ad81460a2fed53ab55bb8d288120c6426eed92129c2479cdc42699b325e9282 */
/* body sha256:71085358a15eaf960a4d884bcf6e4aeaaaa084276c91aafd0b130d905bce8cbf */
/* rigid_body: 3 coordinates, 0 constraint rows, 18 states.
 * Link rigid_body.c with a program of your own, or import the Python module built from rigid_body.pyx. */
#ifndef EM_MODEL_rigid_body_H
#define EM_MODEL_rigid_body_H

#include "eigenmotion.h"

extern const em_model rigid_body_model;

#endif
