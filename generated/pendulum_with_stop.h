/* eigenmotion generate pendulum_with_stop.py */
/* input sha256:b44ef6b31bf1b97df0a8fc11e904ff67a8797029c5ee104a80e2ef00721a809e */
/* body sha256:6119cef16726203361276eaef26e2a7611e185f0c747ad6cab298483932012a9 */
/* pendulum_with_stop: 1 coordinates, 1 constraint rows, 2 states.
 * Link pendulum_with_stop.c with a program of your own,
 * or import the Python module built from pendulum_with_stop.pyx. */
#ifndef EM_MODEL_pendulum_with_stop_H
#define EM_MODEL_pendulum_with_stop_H

#include "eigenmotion.h"

/* Seen from outside of a library, whatever else it hides. */
__attribute__((visibility("default"))) extern const em_model pendulum_with_stop_model;

#endif
