/* eigenmotion generate four_bar.py */
/* input sha256:b4c583928ba1d4df4cfe154941caa7e2d2955825501d803b35f7c71dee2c238e */
/* body sha256:35ec7478d7aa0de52c621243d431cea10838487d1a9c85b6e2375428c85161e1 */
/* four_bar: 3 coordinates, 2 constraint rows, 12 states.
 * Link four_bar.c with a program of your own,
 * or import the Python module built from four_bar.pyx. */
#ifndef EM_MODEL_four_bar_H
#define EM_MODEL_four_bar_H

#include "eigenmotion.h"

extern const em_model four_bar_model;

#endif
