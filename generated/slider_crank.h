/* eigenmotion generate slider_crank.py */
/* input sha256:7cb77f22c00e11b906340db647b0e2361b37b4e94c0c24a7db9afc9e3e99b587 */
/* body sha256:8e774e5bd4afe32506ab8f75ed0bd0a21ef12967a89a4e9e3ada427646852c1f */
/* slider_crank: 3 coordinates, 2 constraint rows, 12 states.
 * Link slider_crank.c with a program of your own, or import the Python module built from slider_crank.pyx. */
#ifndef EM_MODEL_slider_crank_H
#define EM_MODEL_slider_crank_H

#include "eigenmotion.h"

extern const em_model slider_crank_model;

#endif
