/* eigenmotion generate bouncing_ball.py */
/* input sha256:a32b1e6aa8f95644e895a7d8fef01cbd8f56ebac1ee25cfa6f861827098e1439 */
/* body sha256:812cbe837e3685689499e161d8b4fa1075f2cde268790b5b8cfdfb24b7d17c62 */
/* bouncing_ball: 2 coordinates, 1 constraint rows, 4 states.
 * Link bouncing_ball.c with a program of your own,
 * or import the Python module built from bouncing_ball.pyx. */
#ifndef EM_MODEL_bouncing_ball_H
#define EM_MODEL_bouncing_ball_H

#include "eigenmotion.h"

/* Seen from outside of a library, whatever else it hides. */
__attribute__((visibility("default"))) extern const em_model bouncing_ball_model;

#endif
