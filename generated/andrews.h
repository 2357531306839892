/* eigenmotion generate andrews.py */
/* input sha256:47076c895491e33c6f1b2e4cf1517bfbd90585aaa5f4b50327649f93c79156b2 */
/* body sha256:8ece8006792032286c1815d589a62d4d84edb194098f2a345f978bc46764a45b */
/* andrews: 7 coordinates, 6 constraint rows, 32 states.
 * Link andrews.c with a program of your own,
 * or import the Python module built from andrews.pyx. */
#ifndef EM_MODEL_andrews_H
#define EM_MODEL_andrews_H

#include "eigenmotion.h"

extern const em_model andrews_model;

#endif
