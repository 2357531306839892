/* eigenmotion generate puma.py */
/* input sha256:44f9309bb8b2d719e1a6d8e72a68752f8590b0520274b45dad0cbd7ef656c8aa */
/* body sha256:71b12c7979893d25b018ed2a5dffe904bba4046203421f1d639ec70221ec9986 */
/* puma: 6 coordinates, 0 constraint rows, 54 states.
 * Link puma.c with a program of your own,
 * or import the Python module built from puma.pyx. */
#ifndef EM_MODEL_puma_H
#define EM_MODEL_puma_H

#include "eigenmotion.h"

/* Seen from outside of a library, whatever else it hides. */
__attribute__((visibility("default"))) extern const em_model puma_model;

#endif
