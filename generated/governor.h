/* eigenmotion generate governor.py */
/* input sha256:202dd52e577d65d0bddec872924c315ac3164fbae4484a324e9d7f2fd425c856 */
/* body sha256:75401853d2c989fedc94aff8d63dec091bcbcd04c18734814ab805a625349758 */
/* governor: 4 coordinates, 0 constraint rows, 8 states.
 * Link governor.c with a program of your own,
 * or import the Python module built from governor.pyx. */
#ifndef EM_MODEL_governor_H
#define EM_MODEL_governor_H

#include "eigenmotion.h"

/* Seen from outside of a library, whatever else it hides. */
__attribute__((visibility("default"))) extern const em_model governor_model;

#endif
