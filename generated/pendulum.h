/* eigenmotion generate pendulum.py */
/* input sha256:747372358c3f115f509f99a239330acefa4cd44def4742bcb2d1d0d38724b30b */
/* body sha256:8cda7bd32abe4ef89e2d31e7d807b019ac091e6961d25b4c4e2669873489ddfb */
/* pendulum: 1 coordinates, 0 constraint rows, 2 states.
 * Link pendulum.c with a program of your own, or import the Python module built from pendulum.pyx. */
#ifndef EM_MODEL_pendulum_H
#define EM_MODEL_pendulum_H

#include "eigenmotion.h"

extern const em_model pendulum_model;

#endif
