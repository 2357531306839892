/* eigenmotion generate pendulum.py */
/* input sha256:1d29c9c54ee1d964305b3fed8997b249573cb5c2ca5c6367d604281b594a43ab */
/* body sha256:82f53b4cbe24febd13d45290003fee5c995816d3bfcc41ee9a73511bb440833d */
/* pendulum: 1 coordinates, 0 constraint rows, 2 states.
 * Link pendulum.c with a program of your own,
 * or import the Python module built from pendulum.pyx. */
#ifndef EM_MODEL_pendulum_H
#define EM_MODEL_pendulum_H

#include "eigenmotion.h"

/* Visible from outside of a library, whatever else it hides. */
__attribute__((visibility("default"))) extern const em_model pendulum_model;

#endif
