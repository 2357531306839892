/* eigenmotion generate polar_particle.py */
/* input sha256:a5a4c120f61c6010893266c3b8388733a7ed17cc17263602f481dafbf1da45e9 */
/* body sha256:c65353425fc431e6e5d839bf1d273ee1ddc6688ba77510fbd289db8ab48f76f4 */
/* polar_particle: 2 coordinates, 0 constraint rows, 4 states.
 * Link polar_particle.c with a program of your own, or import the Python module built from polar_particle.pyx. */
#ifndef EM_MODEL_polar_particle_H
#define EM_MODEL_polar_particle_H

#include "eigenmotion.h"

extern const em_model polar_particle_model;

#endif
