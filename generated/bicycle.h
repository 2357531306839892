/* eigenmotion generate bicycle.py */
/* input sha256:6aab49efe412f9e2376a6a40a15d69c742564dd7bf6899b0495dbaa7b7dd103e */
/* body sha256:1f5709c4827615b9b96a7aba42838e951d157afb01ee94154d6a3a96bf27f7da */
/* bicycle: 8 coordinates, 5 constraint rows, 88 states.
 * Link bicycle.c with a program of your own,
 * or import the Python module built from bicycle.pyx. */
#ifndef EM_MODEL_bicycle_H
#define EM_MODEL_bicycle_H

#include "eigenmotion.h"

/* Seen from outside of a library, whatever else it hides. */
__attribute__((visibility("default"))) extern const em_model bicycle_model;

#endif
