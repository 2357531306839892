/* eigenmotion generate drone.py */
/* input sha256:54ce1e572a6e83c71b949c868f9ca891676ab1d2e981f80cbcd282ef5642bbe9 */
/* body sha256:335de84d58457195863ffffa2706fecf0ea08fe9c92392323b05637279555e6b */
/* drone: 8 coordinates, 0 constraint rows, 58 states.
 * Link drone.c with a program of your own,
 * or import the Python module built from drone.pyx. */
#ifndef EM_MODEL_drone_H
#define EM_MODEL_drone_H

#include "eigenmotion.h"

extern const em_model drone_model;

#endif
