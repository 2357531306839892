/* eigenmotion generate elastic_pendulum.py */
/* input sha256:0ef93e4c29cf9a08fc935e31d47b41a8de7fcfb3b1c1f5e770622d5afc8920a2 */
/* body sha256:85b7681791941185214e2b5c93e9daed8823760e3417c6e87111d1d50c8a536e */
/* elastic_pendulum: 2 coordinates, 0 constraint rows, 4 states.
 * Link elastic_pendulum.c with a program of your own,
 * or import the Python module built from elastic_pendulum.pyx. */
#ifndef EM_MODEL_elastic_pendulum_H
#define EM_MODEL_elastic_pendulum_H

#include "eigenmotion.h"

/* Seen from outside of a library, whatever else it hides. */
__attribute__((visibility("default"))) extern const em_model elastic_pendulum_model;

#endif
