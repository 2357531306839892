/* eigenmotion generate elastic_pendulum.py */
/* input sha256:39e60f85e6f5c9138edbea7b5f97cbd3c8cf4aaad2f86d8dfe5ab9121ba1fa69 */
/* body sha256:8669faaed4ac9354711f5bb53c9167433ad493f11e16bb777692c084c893b452 */
/* elastic_pendulum: 2 coordinates, 0 constraint rows, 4 states.
 * Link elastic_pendulum.c with a program of your own, or import the Python module built from elastic_pendulum.pyx. */
#ifndef EM_MODEL_elastic_pendulum_H
#define EM_MODEL_elastic_pendulum_H

#include "eigenmotion.h"

extern const em_model elastic_pendulum_model;

#endif
