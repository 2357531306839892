/* eigenmotion generate heavy_top.py */
/* input sha256:ab2a0bf2e44a22e4703a4822a73ab170ccc0694b36b9c922ea402e2b39d6abea */
/* body sha256:085998b087cf39eabd2367f631307cdca924f879c424e30d07f57096368fbdf2 */
/* heavy_top: 3 coordinates, 0 constraint rows, 12 states.
 * Link heavy_top.c with a program of your own, or import the Python module built from heavy_top.pyx. */
#ifndef EM_MODEL_heavy_top_H
#define EM_MODEL_heavy_top_H

#include "eigenmotion.h"

extern const em_model heavy_top_model;

#endif
