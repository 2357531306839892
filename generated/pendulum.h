/* eigenmotion generate pendulum.py */
/* input sha256:4cb3d75cfa750254dd7c7a92a151c59bb658f7285d3817bfdd1092f33379d1ad */
/* body sha256:f6c8fc295b2ca4101b7cb6c5a5258fe147337c04cddda58f2a2fec0ce04b15b1 */
/* pendulum: 1 coordinates, 0 constraint rows, 2 states.
 * Link pendulum.c with a program of your own,
 * or import the Python module built from pendulum.pyx. */
#ifndef EM_MODEL_pendulum_H
#define EM_MODEL_pendulum_H

#include "eigenmotion.h"

/* Exported from a library, even if other symbols are hidden. */
__attribute__((visibility("default"))) extern const em_model pendulum_model;

#endif
