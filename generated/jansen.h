/* eigenmotion generate jansen.py */
/* input sha256:f744e812ddbbe356574aebfde26a89931e0d70e4b66e96c84fbd1461918df3df */
/* body sha256:23fdd01b0deeba1302e289edd34e4ab3c48722b851c52b5110cb8a4b3d24b352 */
/* jansen: 7 coordinates, 6 constraint rows, 70 states.
 * Link jansen.c with a program of your own,
 * or import the Python module built from jansen.pyx. */
#ifndef EM_MODEL_jansen_H
#define EM_MODEL_jansen_H

#include "eigenmotion.h"

/* Seen from outside of a library, whatever else it hides. */
__attribute__((visibility("default"))) extern const em_model jansen_model;

#endif
