/* eigenmotion generate block_on_incline.py */
/* input sha256:c26f72922a994b4dc497d7af21797b6854d219ac767e75b231b2ab6b2c43140a */
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
