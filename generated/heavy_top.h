/* eigenmotion generate heavy_top.py */
/* input sha256:e9f4f2af0643a8c63945119eebe764f39e032a7055c33453fcb301da0a3521f3 */
/* body sha256:dd359d6590cc628c9466b0dfd5a07f79c60daebb3991750c34002ad416fd877a */
/* heavy_top: 3 coordinates, 0 constraint rows, 12 states.
 * Link heavy_top.c with a program of your own,
 * or import the Python module built from heavy_top.pyx. */
#ifndef EM_MODEL_heavy_top_H
#define EM_MODEL_heavy_top_H

#include "eigenmotion.h"

/* Seen from outside of a library, whatever else it hides. */
__attribute__((visibility("default"))) extern const em_model heavy_top_model;

#endif
