/* eigenmotion generate rigid_body.py */
/* input sha256:6a1fe9ffd82e911c66db48438e1fdf5de1dc79f32cda1ff870839cf9ae9e6072 */
/* body sha256:b4c2025d23619bc07f9b93264b8b27c88bb38976f0b561533ea62b3a62df129e */
/* rigid_body: 3 coordinates, 0 constraint rows, 18 states.
 * Link rigid_body.c with a program of your own,
 * or import the Python module built from rigid_body.pyx. */
#ifndef EM_MODEL_rigid_body_H
#define EM_MODEL_rigid_body_H

#include "eigenmotion.h"

extern const em_model rigid_body_model;

#endif
