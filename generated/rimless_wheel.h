/* eigenmotion generate rimless_wheel.py */
/* input sha256:bce80e9863561a6e1bf2c46ba9e8914030752e914806d6722b4f921044fa3a3c */
/* body sha256:b59127f12ff63094f85ff7ab3fb3f7b78a7d39e8fc3d74692cc4f686a556adc0 */
/* rimless_wheel: 1 coordinates, 0 constraint rows, 2 states.
 * Link rimless_wheel.c with a program of your own,
 * or import the Python module built from rimless_wheel.pyx. */
#ifndef EM_MODEL_rimless_wheel_H
#define EM_MODEL_rimless_wheel_H

#include "eigenmotion.h"

extern const em_model rimless_wheel_model;

#endif
