/* eigenmotion generate furuta_pendulum.py */
/* input sha256:dced2f2c1ea16d2797caf600d1ec2362b8e6a46eb1ab952a01482755b88fb96a */
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
