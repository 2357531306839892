/* eigenmotion generate bicycle.py */
/* input sha256:6aab49efe412f9e2376a6a40a15d69c742564dd7bf6899b0495dbaa7b7dd103e */
/* body sha256:13f71adcca3e8980068790f8f421143815eccbae33c8eaaa422aa527c4389777 */
/* bicycle: 8 coordinates, 5 constraint rows, 88 states.
 * Link bicycle.c with a program of your own,
 * or import the Python module built from bicycle.pyx. */
#ifndef EM_MODEL_bicycle_H
#define EM_MODEL_bicycle_H

#include "eigenmotion.h"

extern const em_model bicycle_model;

#endif
