/* eigenmotion generate bricard.py */
/* input sha256:8bfed4695aa35d8d063cad4540c1a879bca63331457e2dff1caab598a87465d9 */
/* body sha256:85105e0f18ab15646afa8be2922f47c540b4b763314ef19a04c4034d01250e7a */
/* bricard: 5 coordinates, 4 constraint rows, 40 states.
 * Link bricard.c with a program of your own, or import the Python module built from bricard.pyx. */
#ifndef EM_MODEL_bricard_H
#define EM_MODEL_bricard_H

#include "eigenmotion.h"

extern const em_model bricard_model;

#endif
