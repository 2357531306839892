/* eigenmotion generate four_bar.py */
/* input sha256:21af7780f4e288bbc9d4774db39293c3d125a8c5f0bf9923da98791e96556c1e */
/* body sha256:400fac9a303161206f5b11d48fd023b9ac1e3430ef252d6c986ae187b6aa5449 */
/* four_bar: 3 coordinates, 2 constraint rows, 12 states.
 * Link four_bar.c with a program of your own, or import the Python module built from four_bar.pyx. */
#ifndef EM_MODEL_four_bar_H
#define EM_MODEL_four_bar_H

#include "eigenmotion.h"

extern const em_model four_bar_model;

#endif
