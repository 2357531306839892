/* eigenmotion generate puma.py */
/* input sha256:44f9309bb8b2d719e1a6d8e72a68752f8590b0520274b45dad0cbd7ef656c8aa */
/* body sha256:53d3ebeeeb3a0c16fc4e1a2561a249ad568c97dd44d421a4ffde2829593a37f6 */
/* puma: 6 coordinates, 0 constraint rows, 54 states.
 * Link puma.c with a program of your own, or import the Python module built from puma.pyx. */
#ifndef EM_MODEL_puma_H
#define EM_MODEL_puma_H

#include "eigenmotion.h"

extern const em_model puma_model;

#endif
