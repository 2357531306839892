/* eigenmotion generate bouncing_ball.py */
/* input sha256:b7d000c069f0520add35771fdb7290225e3d5e3978791ce23beb67cb08a91940 */
/* body sha256:9db7c330e2c05e7ddc6007d601ae1f3ac47ec8fad606ad3fa46618aab7a42e3c */
/* bouncing_ball: 2 coordinates, 1 constraint rows, 4 states.
 * Link bouncing_ball.c with a program of your own, or import the Python module built from bouncing_ball.pyx. */
#ifndef EM_MODEL_bouncing_ball_H
#define EM_MODEL_bouncing_ball_H

#include "eigenmotion.h"

extern const em_model bouncing_ball_model;

#endif
