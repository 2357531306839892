/* eigenmotion generate block_on_incline.py */
/* input sha256:4e77346be5abf3a7f0fe4d15f59885874f78e36aee412330700bde3f765b0ca6 */
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
