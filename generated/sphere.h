/* eigenmotion generate sphere.py */
/* input sha256:fbd5f25b368f8e9a515de98d41a0d309d988e20f65c0862d1dd5d5e53c4ea918 */
/* body sha256:1615d635efc22db8b40b1c1733eac537a0fc1db9a5076ee603e47b76bd507cfe */
/* sphere: 5 coordinates, 2 constraint rows, 22 states.
 * Link sphere.c with a program of your own, or import the Python module built from sphere.pyx. */
#ifndef EM_MODEL_sphere_H
#define EM_MODEL_sphere_H

#include "eigenmotion.h"

extern const em_model sphere_model;

#endif
