/* eigenmotion generate rimless_wheel.py */
/* input sha256:bce80e9863561a6e1bf2c46ba9e8914030752e914806d6722b4f921044fa3a3c */
/* body sha256:c25d0019782e662a8618b111bff91c0228a7dbc78ff8c7d1fcab7d37e23d437a */
/* rimless_wheel: 1 coordinates, 0 constraint rows, 2 states.
 * Link rimless_wheel.c with a program of your own,
 * or import the Python module built from rimless_wheel.pyx. */
#ifndef EM_MODEL_rimless_wheel_H
#define EM_MODEL_rimless_wheel_H

#include "eigenmotion.h"

/* Seen from outside of a library, whatever else it hides. */
__attribute__((visibility("default"))) extern const em_model rimless_wheel_model;

#endif
