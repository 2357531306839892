/* eigenmotion generate clock.py */
/* input sha256:30bb022e4f03f12696dfe7410ea21eb6ee4bb8a47c01f6ef858679d48cf0d0a0 */
/* body sha256:ea4cc606bb7b3cc562b5a057a8b8a4ec78bc9e194d0e63689fdf189a76f631f0 */
/* clock: 1 coordinates, 1 constraint rows, 2 states.
 * Link clock.c with a program of your own, or import the Python module built from clock.pyx. */
#ifndef EM_MODEL_clock_H
#define EM_MODEL_clock_H

#include "eigenmotion.h"

extern const em_model clock_model;

#endif
