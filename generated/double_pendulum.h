/* eigenmotion generate double_pendulum.py */
/* input sha256:2aa8c78fd5de9dcc95b82b3b59485521f0f69d4545624273923556883aeddf96 */
/* body sha256:efe953b9e143c7ce3504a865f3f0d045d31e77715979a811e29b3ca165452624 */
/* double_pendulum: 2 coordinates, 0 constraint rows, 10 states.
 * Link double_pendulum.c with a program of your own,
 * or import the Python module built from double_pendulum.pyx. */
#ifndef EM_MODEL_double_pendulum_H
#define EM_MODEL_double_pendulum_H

#include "eigenmotion.h"

/* Seen from outside of a library, whatever else it hides. */
__attribute__((visibility("default"))) extern const em_model double_pendulum_model;

#endif
