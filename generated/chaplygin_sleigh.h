/* eigenmotion generate chaplygin_sleigh.py */
/* input sha256:35e27e9d3d20f61168b3296735ce61a8edf1a8e47039a3921c2c69cbaca2e61e */
/* body sha256:e9372dd3e4062b92827d6ea6ab5bbe01018324d58bf9f128f79df059e9ba77a6 */
/* chaplygin_sleigh: 3 coordinates, 1 constraint rows, 18 states.
 * Link chaplygin_sleigh.c with a program of your own, or import the Python module built from chaplygin_sleigh.pyx. */
#ifndef EM_MODEL_chaplygin_sleigh_H
#define EM_MODEL_chaplygin_sleigh_H

#include "eigenmotion.h"

extern const em_model chaplygin_sleigh_model;

#endif
