/* eigenmotion generate pendulum.py */
/* input sha256:1d29c9c54ee1d964305b3fed8997b249573cb5c2ca5c6367d604281b594a43ab */
/* body sha256:25fe38f1db4c2b2897d945a8653cd317dc07e0928fb55dd455e2625cbc01005b */
/* pendulum: 1 coordinates, 0 constraint rows, 2 states.
 * Link pendulum.c with a program of your own,
 * or import the Python module built from pendulum.pyx. */
#ifndef EM_MODEL_pendulum_H
#define EM_MODEL_pendulum_H

#include "eigenmotion.h"

/* Seen from outside of a library, whatever else it hides. */
__attribute__((visibility("default"))) extern const em_model pendulum_model;

#endif
