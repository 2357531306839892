/* eigenmotion generate snakeboard.py */
/* input sha256:d70ece58f05e5f9e65f4727d2ec66dffb4d52447c0fb6fbf54b7fa75292c5627 */
/* body sha256:fbfcb226a7fa70bb9a5dbe826678ada805c989959bf3706294168daf8f8a34e7 */
/* snakeboard: 5 coordinates, 2 constraint rows, 10 states.
 * Link snakeboard.c with a program of your own,
 * or import the Python module built from snakeboard.pyx. */
#ifndef EM_MODEL_snakeboard_H
#define EM_MODEL_snakeboard_H

#include "eigenmotion.h"

/* Seen from outside of a library, whatever else it hides. */
__attribute__((visibility("default"))) extern const em_model snakeboard_model;

#endif
