/* eigenmotion generate furuta_pendulum.py */
/* input sha256:ff36814f2b05e1933e30609683e774f079afb7c3e2680d8a3357697eb6b0dfaf */
/* body sha256:95889465be9d3f31b9410b849b6d69c08ab5607945fc9555f116c1ef758af391 */
/* furuta_pendulum: 2 coordinates, 0 constraint rows, 10 states.
 * Link furuta_pendulum.c with a program of your own,
 * or import the Python module built from furuta_pendulum.pyx. */
#ifndef EM_MODEL_furuta_pendulum_H
#define EM_MODEL_furuta_pendulum_H

#include "eigenmotion.h"

/* Seen from outside of a library, whatever else it hides. */
__attribute__((visibility("default"))) extern const em_model furuta_pendulum_model;

#endif
