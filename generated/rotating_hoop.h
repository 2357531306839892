/* eigenmotion generate rotating_hoop.py */
/* input sha256:91f6f125ac6551bd9cf88510480f1923246c6be87362fb13506e726f648eeef6 */
/* body sha256:0b5f98c18cdba7c65a859910d5981e3bbb97f7dafc3d66c20163324f57228d4b */
/* rotating_hoop: 1 coordinates, 0 constraint rows, 2 states.
 * Link rotating_hoop.c with a program of your own,
 * or import the Python module built from rotating_hoop.pyx. */
#ifndef EM_MODEL_rotating_hoop_H
#define EM_MODEL_rotating_hoop_H

#include "eigenmotion.h"

extern const em_model rotating_hoop_model;

#endif
