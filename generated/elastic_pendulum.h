/* eigenmotion generate elastic_pendulum.py */
/* input sha256:c8ba913f87c3abd26af6346ccb6abc3e3ca589aa6ebfa43fc872ee63f073c69a */
/* body sha256:8669faaed4ac9354711f5bb53c9167433ad493f11e16bb777692c084c893b452 */
/* elastic_pendulum: 2 coordinates, 0 constraint rows, 4 states.
 * Link elastic_pendulum.c with a program of your own, or import the Python module built from elastic_pendulum.pyx. */
#ifndef EM_MODEL_elastic_pendulum_H
#define EM_MODEL_elastic_pendulum_H

#include "eigenmotion.h"

extern const em_model elastic_pendulum_model;

#endif
