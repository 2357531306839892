/* eigenmotion generate pendulum.py */
/* input sha256:d53f6c3fdecb6f24b59994a52196687fc85759167453b9057cbc490f9c45eff3 */
/* body sha256:f4ce1ea749662a06fb1ca3a269e63c4bc3ab5002aaecefe3daf3cf657979023f */
/* pendulum: 1 coordinates, 0 constraint rows, 2 states.
 * Link pendulum.c with a program of your own,
 * or import the Python module built from pendulum.pyx. */
#ifndef EM_MODEL_pendulum_H
#define EM_MODEL_pendulum_H

#include "eigenmotion.h"

extern const em_model pendulum_model;

#endif
