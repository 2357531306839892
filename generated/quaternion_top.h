/* eigenmotion generate quaternion_top.py */
/* input sha256:bf6259fcdfc628508d0a3ec4939020d96e3c787e9b0acbb82fc8715aa5a14141 */
/* body sha256:57652bc1ded3b72e97da907a535db36dba3af84bd3427aa242e92aec826a07c5 */
/* quaternion_top: 4 coordinates, 1 constraint rows, 28 states.
 * Link quaternion_top.c with a program of your own,
 * or import the Python module built from quaternion_top.pyx. */
#ifndef EM_MODEL_quaternion_top_H
#define EM_MODEL_quaternion_top_H

#include "eigenmotion.h"

extern const em_model quaternion_top_model;

#endif
