/* eigenmotion generate chain.py */
/* input sha256:0506ee54a3c19fd207366e2d62591b27b9b329b4734ce46f7572381b4a1eb82f */
/* body sha256:f2eed3f065d355a93c3f522ee76daa93befa7273d775907a788f4e9ddd1e358c */
/* chain_5: 5 coordinates, 0 constraint rows, 40 states.
 * Link chain_5.c with a program of your own,
 * or import the Python module built from chain_5.pyx. */
#ifndef EM_MODEL_chain_5_H
#define EM_MODEL_chain_5_H

#include "eigenmotion.h"

/* Seen from outside of a library, whatever else it hides. */
__attribute__((visibility("default"))) extern const em_model chain_5_model;

#endif
