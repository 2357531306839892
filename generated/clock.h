/* eigenmotion generate clock.py */
/* input sha256:5eb67c8748c02dcc6bbf57a5b1dbe700de17cc670abb7136047bcfa5d3ee7185 */
/* body sha256:f7760144f65f7b7c14f512044bc5c0d7af0ead6e17cacbc5711b4a21ae803326 */
/* clock: 1 coordinates, 1 constraint rows, 2 states.
 * Link clock.c with a program of your own,
 * or import the Python module built from clock.pyx. */
#ifndef EM_MODEL_clock_H
#define EM_MODEL_clock_H

#include "eigenmotion.h"

/* Seen from outside of a library, whatever else it hides. */
__attribute__((visibility("default"))) extern const em_model clock_model;

#endif
