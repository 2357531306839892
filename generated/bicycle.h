/* eigenmotion generate bicycle.py */
/* input sha256:6aab49efe412f9e2376a6a40a15d69c742564dd7bf6899b0495dbaa7b7dd103e */
/* body sha256:a49a000d7b85ebdb781cd607ad53110e964319c6f9199b9b6062ac59535f81a0 */
/* bicycle: 8 coordinates, 5 constraint rows, 88 states.
 * Link bicycle.c with a program of your own, or import the Python module built from bicycle.pyx. */
#ifndef EM_MODEL_bicycle_H
#define EM_MODEL_bicycle_H

#include "eigenmotion.h"

extern const em_model bicycle_model;

#endif
