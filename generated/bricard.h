/* eigenmotion generate bricard.py */
/* input sha256:48de1137e7976971392b7b646ac5f51dbece29e92877180f29ab43eea45f1cf4 */
/* body sha256:85105e0f18ab15646afa8be2922f47c540b4b763314ef19a04c4034d01250e7a */
/* bricard: 5 coordinates, 4 constraint rows, 40 states.
 * Link bricard.c with a program of your own, or import the Python module built from bricard.pyx. */
#ifndef EM_MODEL_bricard_H
#define EM_MODEL_bricard_H

#include "eigenmotion.h"

extern const em_model bricard_model;

#endif
