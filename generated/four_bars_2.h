/* eigenmotion generate four_bars.py */
/* input sha256:d44b8a1b43ef5c6b759d4c18e4766756f5a9376280ce8c564f8348a6e35e6df3 */
/* body sha256:7b4378d2999d60bf3615490378023ee928edc7d8f117af529246c3d951641cba */
/* four_bars_2: 5 coordinates, 4 constraint rows, 22 states.
 * Link four_bars_2.c with a program of your own, or import the Python module built from four_bars_2.pyx. */
#ifndef EM_MODEL_four_bars_2_H
#define EM_MODEL_four_bars_2_H

#include "eigenmotion.h"

extern const em_model four_bars_2_model;

#endif
