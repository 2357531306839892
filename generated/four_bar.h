/* eigenmotion generate four_bar.py */
/* input sha256:10ea64c65b0625c37ac606379d8e7cc0bf2575aa65b654f2e2d516bf1b2ce748 */
/* body sha256:6c16ac0fa6d832dc54e28abadde92a2d08648d31e00705cc5aafffd1924fe33b */
/* four_bar: 3 coordinates, 2 constraint rows, 12 states.
 * Link four_bar.c with a program of your own,
 * or import the Python module built from four_bar.pyx. */
#ifndef EM_MODEL_four_bar_H
#define EM_MODEL_four_bar_H

#include "eigenmotion.h"

/* Exported from a library, even if other symbols are hidden. */
__attribute__((visibility("default"))) extern const em_model four_bar_model;

#endif
