/* eigenmotion generate compass_gait.py */
/* input sha256:56edeb7e4db8895b2d2cf8f221a89a13715f4c291bcea9a7fcf319590b9c2400 */
/* body sha256:524d74dfc50b55161aa4f2b1eb5c89c0d1cd2e05541670cc392d5e609d1f42b4 */
/* compass_gait: 2 coordinates, 0 constraint rows, 10 states.
 * Link compass_gait.c with a program of your own,
 * or import the Python module built from compass_gait.pyx. */
#ifndef EM_MODEL_compass_gait_H
#define EM_MODEL_compass_gait_H

#include "eigenmotion.h"

/* Seen from outside of a library, whatever else it hides. */
__attribute__((visibility("default"))) extern const em_model compass_gait_model;

#endif
