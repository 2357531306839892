/* eigenmotion generate slider_crank.py */
/* input sha256:ec762a02c93cc8269d579033fc99edddab6d23bbe9acf64e06e026178f6ef306 */
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
