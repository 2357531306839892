/* eigenmotion generate governor.py */
/* input sha256:52f684c3c047fbd43e38baf9d086c847e589ee8e98deafbb0551c708cffa2b34 */
/* body sha256:4ba20b37c006ae21654529da7104585c6e2016985c1529dd055aa86804dae427 */
/* governor: 4 coordinates, 0 constraint rows, 8 states.
 * Link governor.c with a program of your own, or import the Python module built from governor.pyx. */
#ifndef EM_MODEL_governor_H
#define EM_MODEL_governor_H

#include "eigenmotion.h"

extern const em_model governor_model;

#endif
