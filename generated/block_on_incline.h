/* eigenmotion generate block_on_incline.py */
/* input sha256:c26f72922a994b4dc497d7af21797b6854d219ac767e75b231b2ab6b2c43140a */
/* body sha256:32eb960ecf3bc7c0fe528f4e6910c8b1217a391f54e47296d994301f4133664b */
/* block_on_incline: 1 coordinates, 1 constraint rows, 2 states.
 * Link block_on_incline.c with a program of your own,
 * or import the Python module built from block_on_incline.pyx. */
#ifndef EM_MODEL_block_on_incline_H
#define EM_MODEL_block_on_incline_H

#include "eigenmotion.h"

extern const em_model block_on_incline_model;

#endif
