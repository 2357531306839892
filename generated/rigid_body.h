/* eigenmotion generate rigid_body.py */
/* input sha256:6a1fe9ffd82e911c66db48438e1fdf5de1dc79f32cda1ff870839cf9ae9e6072 */
/* body sha256:fad685070fb82752edb733e852b1dc06a1e94e19b55fa759e2b14d0b1498c625 */
/* rigid_body: 3 coordinates, 0 constraint rows, 18 states.
 * Link rigid_body.c with a program of your own,
 * or import the Python module built from rigid_body.pyx. */
#ifndef EM_MODEL_rigid_body_H
#define EM_MODEL_rigid_body_H

#include "eigenmotion.h"

/* Seen from outside of a library, whatever else it hides. */
__attribute__((visibility("default"))) extern const em_model rigid_body_model;

#endif
