/* eigenmotion generate slider_crank.py */
/* input sha256:7cb77f22c00e11b906340db647b0e2361b37b4e94c0c24a7db9afc9e3e99b587 */
/* body sha256:6a5d8ea842d7ee6703ea4215e8020aac2a0583dd5591b764b1852a383f8b2735 */
/* slider_crank: 3 coordinates, 2 constraint rows, 12 states.
 * Link slider_crank.c with a program of your own,
 * or import the Python module built from slider_crank.pyx. */
#ifndef EM_MODEL_slider_crank_H
#define EM_MODEL_slider_crank_H

#include "eigenmotion.h"

/* Seen from outside of a library, whatever else it hides. */
__attribute__((visibility("default"))) extern const em_model slider_crank_model;

#endif
