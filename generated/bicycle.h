/* eigenmotion generate bicycle.py */
/* input sha256:086a2e7d83260e45b545b8ae0bfffd95f92bbe57b7720c7c4a3f813b1553452d */
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
