/* eigenmotion generate spatial_arm.py */
/* input sha256:123f02a70e5ee10d7729d33f668f9b52f582ed1181b23d7ac380899a4ad2caa6 */
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
