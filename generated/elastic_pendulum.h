/* eigenmotion generate elastic_pendulum.py */
/* input sha256:0ef93e4c29cf9a08fc935e31d47b41a8de7fcfb3b1c1f5e770622d5afc8920a2 */
/* body sha256:a73aab9001202c1be16acbf21ef2d9fb78558a8b6a4bf23055e411fe8f591b57 */
/* elastic_pendulum: 2 coordinates, 0 constraint rows, 4 states.
 * Link elastic_pendulum.c with a program of your own,
 * or import the Python module built from elastic_pendulum.pyx. */
#ifndef EM_MODEL_elastic_pendulum_H
#define EM_MODEL_elastic_pendulum_H

#include "eigenmotion.h"

extern const em_model elastic_pendulum_model;

#endif
