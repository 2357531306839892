/* eigenmotion generate rimless_wheel.py */
/* input sha256:16083fc70ce4f8f74a2486776ab2e7ad0d28678092f92365b6aa29bbd500868b */
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
