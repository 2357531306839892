/* eigenmotion generate driven_pendulum.py */
/* input sha256:f03e70c1bada2a6ab9bc3811e7865c0ae1b77524d6c1f3ea721379785f3676f2 */
/* body sha256:02b724caef9fd69742d06573b829ca66a39a9e6d179de9b45000bc967d583cb6 */
/* driven_pendulum: 2 coordinates, 1 constraint rows, 4 states.
 * Link driven_pendulum.c with a program of your own, or import the Python module built from driven_pendulum.pyx. */
#ifndef EM_MODEL_driven_pendulum_H
#define EM_MODEL_driven_pendulum_H

#include "eigenmotion.h"

extern const em_model driven_pendulum_model;

#endif
