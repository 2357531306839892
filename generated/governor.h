/* eigenmotion generate governor.py */
/* input sha256:52f684c3c047fbd43e38baf9d086c847e589ee8e98deafbb0551c708cffa2b34 */
/* body sha256:1b529264532878cb23ea3d4f2c5ab6094f60ee29b89156a25ade8ce7a3eed1ec */
/* governor: 4 coordinates, 0 constraint rows, 8 states.
 * Link governor.c with a program of your own,
 * or import the Python module built from governor.pyx. */
#ifndef EM_MODEL_governor_H
#define EM_MODEL_governor_H

#include "eigenmotion.h"

extern const em_model governor_model;

#endif
