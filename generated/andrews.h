/* eigenmotion generate andrews.py */
/* input sha256:771d14621a5f8d802c5503cd56f4fa403aba4e013c8e286a7a5a274fd30492b0 */
/* body sha256:8d88aae3b012f596092f5eec2882dd9844b9f0372c9825c1e53e34bcb5c95111 */
/* andrews: 7 coordinates, 6 constraint rows, 32 states.
 * Link andrews.c with a program of your own,
 * or import the Python module built from andrews.pyx. */
#ifndef EM_MODEL_andrews_H
#define EM_MODEL_andrews_H

#include "eigenmotion.h"

/* Seen from outside of a library, whatever else it hides. */
__attribute__((visibility("default"))) extern const em_model andrews_model;

#endif
