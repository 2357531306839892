/* eigenmotion generate block_on_incline.py */
/* input sha256:b1b408a7f9d0e26e3df392fc98624d7649fdd16a31ca9f2dc5d2843090a3fb07 */
/* body sha256:3ec1e78ac72b0e680533cb974351397983b9a838b17bb0ca3208adee5c918bab */
/* block_on_incline: 1 coordinates, 1 constraint rows, 2 states.
 * Link block_on_incline.c with a program of your own,
 * or import the Python module built from block_on_incline.pyx. */
#ifndef EM_MODEL_block_on_incline_H
#define EM_MODEL_block_on_incline_H

#include "eigenmotion.h"

/* Seen from outside of a library, whatever else it hides. */
__attribute__((visibility("default"))) extern const em_model block_on_incline_model;

#endif
