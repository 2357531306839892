/* eigenmotion generate quaternion_top.py */
/* input sha256:0cb8bde97f7a54b959afa6233ef8b22ba968fd2b37b477c410a8abc46e5c03d5 */
/* body sha256:9f3e5faefc2e06a8e9a635e2b5f049d3ef4f084be277cf4d5e8bcadbdf394345 */
/* quaternion_top: 4 coordinates, 1 constraint rows, 28 states.
 * Link quaternion_top.c with a program of your own,
 * or import the Python module built from quaternion_top.pyx. */
#ifndef EM_MODEL_quaternion_top_H
#define EM_MODEL_quaternion_top_H

#include "eigenmotion.h"

/* Seen from outside of a library, whatever else it hides. */
__attribute__((visibility("default"))) extern const em_model quaternion_top_model;

#endif
