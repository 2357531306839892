/* eigenmotion generate spatial_arm.py */
/* input sha256:eb0934f2152ede69ef7ac9ffbe44f0b4a5879d506634b2a5605fa01a05cc1d6f */
/* body sha256:7d8ca975fc3bbc722d93153590d496f62c10db8a58e9589aa94520d5a497780e */
/* spatial_arm_3: 3 coordinates, 0 constraint rows, 18 states.
 * Link spatial_arm_3.c with a program of your own,
 * or import the Python module built from spatial_arm_3.pyx. */
#ifndef EM_MODEL_spatial_arm_3_H
#define EM_MODEL_spatial_arm_3_H

#include "eigenmotion.h"

extern const em_model spatial_arm_3_model;

#endif
