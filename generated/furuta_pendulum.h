/* eigenmotion generate furuta_pendulum.py */
/* input sha256:ff5abd21ff67e2684d0ea3f81c7d81dc3a232a28c8958cb5c9396bdc1881d943 */
/* body sha256:7a0abc21d5740e44ad7250e719b725f4a3ce79eb8e9797bcb9c4f13e2b4fa80c */
/* furuta_pendulum: 2 coordinates, 0 constraint rows, 10 states.
 * Link furuta_pendulum.c with a program of your own, or import the Python module built from furuta_pendulum.pyx. */
#ifndef EM_MODEL_furuta_pendulum_H
#define EM_MODEL_furuta_pendulum_H

#include "eigenmotion.h"

extern const em_model furuta_pendulum_model;

#endif
