/* eigenmotion generate four_bars.py */
/* input sha256:bcb90918768aa4b82cabda26a10ffab302d61bd800ad437e9fa9db3f90eb0350 */
/* body sha256:5c64f43ba2f9633e78efd7cecda1f2ce27003d55e9d28e5bf2c3c08c5cbc0acb */
/* four_bars_2: 5 coordinates, 4 constraint rows, 22 states.
 * Link four_bars_2.c with a program of your own,
 * or import the Python module built from four_bars_2.pyx. */
#ifndef EM_MODEL_four_bars_2_H
#define EM_MODEL_four_bars_2_H

#include "eigenmotion.h"

/* Seen from outside of a library, whatever else it hides. */
__attribute__((visibility("default"))) extern const em_model four_bars_2_model;

#endif
