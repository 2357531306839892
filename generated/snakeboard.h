/* eigenmotion generate snakeboard.py */
/* input sha256:d70ece58f05e5f9e65f4727d2ec66dffb4d52447c0fb6fbf54b7fa75292c5627 */
/* body sha256:b90744a99919e3c2671295bffd4d93b77824e562c4f21cb3c0465d0ed3b5b716 */
/* snakeboard: 5 coordinates, 2 constraint rows, 10 states.
 * Link snakeboard.c with a program of your own,
 * or import the Python module built from snakeboard.pyx. */
#ifndef EM_MODEL_snakeboard_H
#define EM_MODEL_snakeboard_H

#include "eigenmotion.h"

extern const em_model snakeboard_model;

#endif
