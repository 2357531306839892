/* eigenmotion generate four_bars.py */
/* input sha256:658c33549b1976e7eb748663ea5ab20db4d10933dd69e9b1f174a8be8bf4a1ee */
/* body sha256:7c094dc3ede88ab3703e89dbac035f081616590c4ae4646411387eb7e39f3531 */
/* four_bars_2: 5 coordinates, 4 constraint rows, 22 states.
 * Link four_bars_2.c with a program of your own,
 * or import the Python module built from four_bars_2.pyx. */
#ifndef EM_MODEL_four_bars_2_H
#define EM_MODEL_four_bars_2_H

#include "eigenmotion.h"

extern const em_model four_bars_2_model;

#endif
