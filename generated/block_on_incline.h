/* eigenmotion generate block_on_incline.py */
/* input sha256:c26f72922a994b4dc497d7af21797b6854d219ac767e75b231b2ab6b2c43140a */
/* body sha256:b95735b883bcfe84fa66ddbdc4198497b7178fa370c840fd6bacd8b2005cfa65 */
/* block_on_incline: 1 coordinates, 1 constraint rows, 2 states.
 * Link block_on_incline.c with a program of your own, or import the Python module built from block_on_incline.pyx. */
#ifndef EM_MODEL_block_on_incline_H
#define EM_MODEL_block_on_incline_H

#include "eigenmotion.h"

extern const em_model block_on_incline_model;

#endif
