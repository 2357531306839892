/* eigenmotion generate chaplygin_sleigh.py */
/* input sha256:3d5f0048bd7d07f166f5e27e487e5ada2df1ffaf99a10809e7c8523799804238 */
/* body sha256:121fa89775b81c7661e0d5fef1f8bb4defada38b7734ed3d7d34876ac01777b1 */
/* chaplygin_sleigh: 3 coordinates, 1 constraint rows, 18 states.
 * Link chaplygin_sleigh.c with a program of your own,
 * or import the Python module built from chaplygin_sleigh.pyx. */
#ifndef EM_MODEL_chaplygin_sleigh_H
#define EM_MODEL_chaplygin_sleigh_H

#include "eigenmotion.h"

/* Seen from outside of a library, whatever else it hides. */
__attribute__((visibility("default"))) extern const em_model chaplygin_sleigh_model;

#endif
