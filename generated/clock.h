/* eigenmotion generate clock.py */
/* input sha256:30bb022e4f03f12696dfe7410ea21eb6ee4bb8a47c01f6ef858679d48cf0d0a0 */
/* body sha256:8e3cc5f25d6ec36810f0c4efb352058769d832bdadad7257bd8f04a6d5fce7eb */
/* clock: 1 coordinates, 1 constraint rows, 2 states.
 * Link clock.c with a program of your own,
 * or import the Python module built from clock.pyx. */
#ifndef EM_MODEL_clock_H
#define EM_MODEL_clock_H

#include "eigenmotion.h"

extern const em_model clock_model;

#endif
