/* eigenmotion generate polar_particle.py */
/* input sha256:2ebb6373cfc4d6f8793f1aa682c138d933aea6a77484dc28ef97956eddbfc9f3 */
/* body sha256:e214a16f4ad8005b5014445bd8cbb8569e236ab3031da859d45d3e7897938563 */
/* polar_particle: 2 coordinates, 0 constraint rows, 4 states.
 * Link polar_particle.c with a program of your own,
 * or import the Python module built from polar_particle.pyx. */
#ifndef EM_MODEL_polar_particle_H
#define EM_MODEL_polar_particle_H

#include "eigenmotion.h"

/* Seen from outside of a library, whatever else it hides. */
__attribute__((visibility("default"))) extern const em_model polar_particle_model;

#endif
