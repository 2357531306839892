/* eigenmotion generate bouncing_ball.py */
/* input sha256:b7d000c069f0520add35771fdb7290225e3d5e3978791ce23beb67cb08a91940 */
/* body sha256:3d4bdc96a5883da59eec422b5b256a6c7db60b475fd2c2d5eaa56f046d3c13d2 */
/* bouncing_ball: 2 coordinates, 1 constraint rows, 4 states.
 * Link bouncing_ball.c with a program of your own,
 * or import the Python module built from bouncing_ball.pyx. */
#ifndef EM_MODEL_bouncing_ball_H
#define EM_MODEL_bouncing_ball_H

#include "eigenmotion.h"

extern const em_model bouncing_ball_model;

#endif
