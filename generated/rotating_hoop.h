/* eigenmotion generate rotating_hoop.py */
/* input sha256:27c9b161d2897126bbb058401d1b419c4a8abb4619b4a198898b8f5f4d863812 */
/* body sha256:e2679a8b115ec5bd11ca1becb7097ee2d4bacd2bd78a102c2225f369d7229f0e */
/* rotating_hoop: 1 coordinates, 0 constraint rows, 2 states.
 * Link rotating_hoop.c with a program of your own, or import the Python module built from rotating_hoop.pyx. */
#ifndef EM_MODEL_rotating_hoop_H
#define EM_MODEL_rotating_hoop_H

#include "eigenmotion.h"

extern const em_model rotating_hoop_model;

#endif
