/* eigenmotion generate snakeboard.py */
/* input sha256:d70ece58f05e5f9e65f4727d2ec66dffb4d52447c0fb6fbf54b7fa75292c5627 */
/* body sha256:d4667eab8dae670a611a0e4f2747e5e83672b1f25c6b1030d5c836b5a61504fb */
/* snakeboard: 5 coordinates, 2 constraint rows, 10 states.
 * Link snakeboard.c with a program of your own, or import the Python module built from snakeboard.pyx. */
#ifndef EM_MODEL_snakeboard_H
#define EM_MODEL_snakeboard_H

#include "eigenmotion.h"

extern const em_model snakeboard_model;

#endif
