/* eigenmotion generate chain.py */
/* input sha256:6bbbcf8677f055b932628a08180eff4ad8cf7573a6c8f3a2f34ed490ef046cfd */
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
