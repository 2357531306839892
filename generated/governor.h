/* eigenmotion generate governor.py */
/* input sha256:52f684c3c047fbd43e38baf9d086c847e589ee8e98deafbb0551c708cffa2b34 */
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
