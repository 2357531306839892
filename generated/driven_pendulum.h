/* eigenmotion generate driven_pendulum.py */
/* input sha256:201c7f5c3d9a1a54d72aeebe06a22a39924cfd41aa5031420e238417b4f880f0 */
/* body sha256:f2a84995da237561407368b23abab20d14ae6ecc47e1af2c40a8ab2d24223d79 */
/* driven_pendulum: 2 coordinates, 1 constraint rows, 4 states.
 * Link driven_pendulum.c with a program of your own,
 * or import the Python module built from driven_pendulum.pyx. */
#ifndef EM_MODEL_driven_pendulum_H
#define EM_MODEL_driven_pendulum_H

#include "eigenmotion.h"

extern const em_model driven_pendulum_model;

#endif
