/* eigenmotion generate puma.py */
/* input sha256:44f9309bb8b2d719e1a6d8e72a68752f8590b0520274b45dad0cbd7ef656c8aa */
/* body sha256:9e0548512bc31732627d190481ab6ff2a1c17205b39be8415f1b4e04dca8ab81 */
/* puma: 6 coordinates, 0 constraint rows, 54 states.
 * Link puma.c with a program of your own,
 * or import the Python module built from puma.pyx. */
#ifndef EM_MODEL_puma_H
#define EM_MODEL_puma_H

#include "eigenmotion.h"

extern const em_model puma_model;

#endif
