/* eigenmotion generate sphere.py */
/* input sha256:87fcfceb530674a524220a6812c1bd35ccba13b97f87d16d8ddc76de85c67965 */
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
