/* eigenmotion generate double_pendulum.py */
/* input sha256:2ba4aec21b98ac577a5c3f3ec62f6517f4e00f90a9ae6e680be7b458a5f68f95 */
/* body sha256:88ff18537f62525715d7c8c5bf20806e136f44f37d45ca218527d6018b8327bb */
/* double_pendulum: 2 coordinates, 0 constraint rows, 10 states.
 * Link double_pendulum.c with a program of your own,
 * or import the Python module built from double_pendulum.pyx. */
#ifndef EM_MODEL_double_pendulum_H
#define EM_MODEL_double_pendulum_H

#include "eigenmotion.h"

extern const em_model double_pendulum_model;

#endif
