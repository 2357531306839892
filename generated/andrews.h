/* eigenmotion generate andrews.py */
/* input sha256:47076c895491e33c6f1b2e4cf1517bfbd90585aaa5f4b50327649f93c79156b2 */
/* body sha256:b0f797f04791028462a09eff0016fa92b6156d395510c6008fd390179b252c1f */
/* andrews: 7 coordinates, 6 constraint rows, 32 states.
 * Link andrews.c with a program of your own, or import the Python module built from andrews.pyx. */
#ifndef EM_MODEL_andrews_H
#define EM_MODEL_andrews_H

#include "eigenmotion.h"

extern const em_model andrews_model;

#endif
