/* eigenmotion generate furuta_pendulum.py */
/* input sha256:dced2f2c1ea16d2797caf600d1ec2362b8e6a46eb1ab952a01482755b88fb96a */
/* body sha256:dd0eec6eb8ef090499cbf5942f179bc167a55186a405e45a62d1569eff5cfa39 */
/* furuta_pendulum: 2 coordinates, 0 constraint rows, 10 states.
 * Link furuta_pendulum.c with a program of your own,
 * or import the Python module built from furuta_pendulum.pyx. */
#ifndef EM_MODEL_furuta_pendulum_H
#define EM_MODEL_furuta_pendulum_H

#include "eigenmotion.h"

extern const em_model furuta_pendulum_model;

#endif
