/* eigenmotion generate spatial_arm.py */
/* input sha256:eb0934f2152ede69ef7ac9ffbe44f0b4a5879d506634b2a5605fa01a05cc1d6f */
/* body sha256:7f85d833ffeb7ea06739f2503af43f8b6329f9d9e93d972e7add86e396cbeee6 */
/* spatial_arm_3: 3 coordinates, 0 constraint rows, 18 states.
 * Link spatial_arm_3.c with a program of your own,
 * or import the Python module built from spatial_arm_3.pyx. */
#ifndef EM_MODEL_spatial_arm_3_H
#define EM_MODEL_spatial_arm_3_H

#include "eigenmotion.h"

/* Seen from outside of a library, whatever else it hides. */
__attribute__((visibility("default"))) extern const em_model spatial_arm_3_model;

#endif
