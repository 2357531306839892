/* eigenmotion generate sphere.py */
/* input sha256:05e340b5560a176d60eaba7628c380e1c4df329f4f58343dd20ce5755e07588b */
/* body sha256:715e95222b93b42eb0eef4379905c8faaec29aecb405a1e1f52718cfa28e8b26 */
/* sphere: 5 coordinates, 2 constraint rows, 22 states.
 * Link sphere.c with a program of your own,
 * or import the Python module built from sphere.pyx. */
#ifndef EM_MODEL_sphere_H
#define EM_MODEL_sphere_H

#include "eigenmotion.h"

/* Seen from outside of a library, whatever else it hides. */
__attribute__((visibility("default"))) extern const em_model sphere_model;

#endif
