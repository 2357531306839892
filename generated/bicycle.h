/* eigenmotion generate bicycle.py */
/* input sha256:c2e585a414f6be6297e9673245b24a8235f7ad9b118830528a5d1ab004249dc9 */
/* body sha256:a49a000d7b85ebdb781cd607ad53110e964319c6f9199b9b6062ac59535f81a0 */
/* bicycle: 8 coordinates, 5 constraint rows, 88 states.
 * Link bicycle.c with a program of your own, or import the Python module built from bicycle.pyx. */
#ifndef EM_MODEL_bicycle_H
#define EM_MODEL_bicycle_H

#include "eigenmotion.h"

extern const em_model bicycle_model;

#endif
