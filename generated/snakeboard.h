/* eigenmotion generate snakeboard.py */
/* input sha256:edfccaa8748c847863ae931ce253127968f082a4b6a87f2749e4cd538d34f6e3 */
/* body sha256:d4667eab8dae670a611a0e4f2747e5e83672b1f25c6b1030d5c836b5a61504fb */
/* snakeboard: 5 coordinates, 2 constraint rows, 10 states.
 * Link snakeboard.c with a program of your own, or import the Python module built from snakeboard.pyx. */
#ifndef EM_MODEL_snakeboard_H
#define EM_MODEL_snakeboard_H

#include "eigenmotion.h"

extern const em_model snakeboard_model;

#endif
