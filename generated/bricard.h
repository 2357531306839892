/* eigenmotion generate bricard.py */
/* input sha256:84c95ed96c00d0f879f20a64f2de802bc07fecba092ce5dcb4db62e1a3957270 */
/* body sha256:9a0428135fff93aac2f7a67542bf5b8726b0af5b5d0a80716cd94c3f2bb2a497 */
/* bricard: 5 coordinates, 4 constraint rows, 40 states.
 * Link bricard.c with a program of your own,
 * or import the Python module built from bricard.pyx. */
#ifndef EM_MODEL_bricard_H
#define EM_MODEL_bricard_H

#include "eigenmotion.h"

/* Seen from outside of a library, whatever else it hides. */
__attribute__((visibility("default"))) extern const em_model bricard_model;

#endif
