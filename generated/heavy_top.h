/* eigenmotion generate heavy_top.py */
/* input sha256:7ccdfa2536616d76d097f61367fff237e8a3488b5040ecad7c5299584f0ca358 */
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
