/* eigenmotion generate pendulum.py */
/* input sha256:52fb53e2f4741a5fadc920567d0721d21d1fc192cb58e17ae46f40910c3d51a0 */
/* body sha256:8cda7bd32abe4ef89e2d31e7d807b019ac091e6961d25b4c4e2669873489ddfb */
/* pendulum: 1 coordinates, 0 constraint rows, 2 states.
 * Link pendulum.c with a program of your own, or import the Python module built from pendulum.pyx. */
#ifndef EM_MODEL_pendulum_H
#define EM_MODEL_pendulum_H

#include "eigenmotion.h"

extern const em_model pendulum_model;

#endif
