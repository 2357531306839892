/* eigenmotion generate bouncing_ball.py */
/* input sha256:b7d000c069f0520add35771fdb7290225e3d5e3978791ce23beb67cb08a91940 */
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
