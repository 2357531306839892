/* eigenmotion generate chaplygin_sleigh.py */
/* input sha256:3d5f0048bd7d07f166f5e27e487e5ada2df1ffaf99a10809e7c8523799804238 */
/* body sha256:f2920cbd51e859bd2538c5d029420b8fa260bac55ab2264843495f8b2df796d8 */
/* chaplygin_sleigh: 3 coordinates, 1 constraint rows, 18 states.
 * Link chaplygin_sleigh.c with a program of your own,
 * or import the Python module built from chaplygin_sleigh.pyx. */
#ifndef EM_MODEL_chaplygin_sleigh_H
#define EM_MODEL_chaplygin_sleigh_H

#include "eigenmotion.h"

extern const em_model chaplygin_sleigh_model;

#endif
