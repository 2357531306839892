/* eigenmotion generate spatial_arm.py */
/* input sha256:af167d7b0db6eb5b02838901a00db98915052a45995a6cd114198328b1dc7a4b */
/* body sha256:5b4727c15e117357a35952111ad5e8ffb0f11e70a3888ccd44762c211a1650a7 */
/* spatial_arm_3: 3 coordinates, 0 constraint rows, 18 states.
 * Link spatial_arm_3.c with a program of your own, or import the Python module built from spatial_arm_3.pyx. */
#ifndef EM_MODEL_spatial_arm_3_H
#define EM_MODEL_spatial_arm_3_H

#include "eigenmotion.h"

extern const em_model spatial_arm_3_model;

#endif
