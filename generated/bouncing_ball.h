/* eigenmotion generate bouncing_ball.py */
/* input sha256:4d128ea20431f269a25450ff61477ebcbb2676698bb6448ebdd8d37e15829545 */
/* body sha256:31954ddb748efa3715516767fa7351366892556f19af0b9cec4eabf38e97fdb3 */
/* bouncing_ball: 2 coordinates, 1 constraint rows, 4 states.
 * Link bouncing_ball.c with a program of your own,
 * or import the Python module built from bouncing_ball.pyx. */
#ifndef EM_MODEL_bouncing_ball_H
#define EM_MODEL_bouncing_ball_H

#include "eigenmotion.h"

/* Exported from a library, even if other symbols are hidden. */
__attribute__((visibility("default"))) extern const em_model bouncing_ball_model;

#endif
