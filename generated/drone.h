/* eigenmotion generate drone.py */
/* input sha256:4f11df1f7d176811d0bb3694586688568505c1f4ec024bed8c913586a1914019 */
/* body sha256:3ad24b684a10dd454519be0fa4e11db2f38d97c5065c5833afe83ab0a4da0439 */
/* drone: 8 coordinates, 0 constraint rows, 58 states.
 * Link drone.c with a program of your own,
 * or import the Python module built from drone.pyx. */
#ifndef EM_MODEL_drone_H
#define EM_MODEL_drone_H

#include "eigenmotion.h"

/* Seen from outside of a library, whatever else it hides. */
__attribute__((visibility("default"))) extern const em_model drone_model;

#endif
