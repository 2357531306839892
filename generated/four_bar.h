/* eigenmotion generate four_bar.py */
/* input sha256:1333e250796aa24c7022f1769be0265d1e729ac8be35d568f550fb6797500387 */
/* body sha256:d8115f04647049b3a819c58783ff7111eeefcbe76cad90ea9618ed089d23be75 */
/* four_bar: 3 coordinates, 2 constraint rows, 12 states.
 * Link four_bar.c with a program of your own,
 * or import the Python module built from four_bar.pyx. */
#ifndef EM_MODEL_four_bar_H
#define EM_MODEL_four_bar_H

#include "eigenmotion.h"

/* Visible from outside of a library, whatever else it hides. */
__attribute__((visibility("default"))) extern const em_model four_bar_model;

#endif
