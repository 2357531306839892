/* eigenmotion generate sphere.py */
/* input sha256:05e340b5560a176d60eaba7628c380e1c4df329f4f58343dd20ce5755e07588b */
/* body sha256:7a71f54fb99a2e05883a9da20fe0088e032c9a5bd477cde44cbe590d9fddcb64 */
/* sphere: 5 coordinates, 2 constraint rows, 22 states.
 * Link sphere.c with a program of your own,
 * or import the Python module built from sphere.pyx. */
#ifndef EM_MODEL_sphere_H
#define EM_MODEL_sphere_H

#include "eigenmotion.h"

extern const em_model sphere_model;

#endif
