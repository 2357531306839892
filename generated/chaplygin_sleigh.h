/* eigenmotion generate chaplygin_sleigh.py */
/* input sha256:3d5f0048bd7d07f166f5e27e487e5ada2df1ffaf99a10809e7c8523799804238 */
/* body sha256:e9372dd3e4062b92827d6ea6ab5bbe01018324d58bf9f128f79df059e9ba77a6 */
/* chaplygin_sleigh: 3 coordinates, 1 constraint rows, 18 states.
 * Link chaplygin_sleigh.c with a program of your own, or import the Python module built from chaplygin_sleigh.pyx. */
#ifndef EM_MODEL_chaplygin_sleigh_H
#define EM_MODEL_chaplygin_sleigh_H

#include "eigenmotion.h"

extern const em_model chaplygin_sleigh_model;

#endif
