/* eigenmotion generate rotating_hoop.py */
/* input sha256:4ca9addd468a058aeba8298bc6f067c6fa0c357b0c760d5dcdd74ae9ced7b69a */
/* body sha256:e2679a8b115ec5bd11ca1becb7097ee2d4bacd2bd78a102c2225f369d7229f0e */
/* rotating_hoop: 1 coordinates, 0 constraint rows, 2 states.
 * Link rotating_hoop.c with a program of your own, or import the Python module built from rotating_hoop.pyx. */
#ifndef EM_MODEL_rotating_hoop_H
#define EM_MODEL_rotating_hoop_H

#include "eigenmotion.h"

extern const em_model rotating_hoop_model;

#endif
