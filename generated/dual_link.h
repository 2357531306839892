/* eigenmotion generate dual_link.py */
/* input sha256:db7ffc172ffdf80cd8a7345118304d621e67bf6a384cc2081b57636f2bda4deb */
/* body sha256:b9176c3e0832cd5d4cf37030a3dc0f0a3f17f8fde7241e09e048a27db503ebed */
/* dual_link: 4 coordinates, 1 constraint rows, 20 states.
 * Link dual_link.c with a program of your own,
 * or import the Python module built from dual_link.pyx. */
#ifndef EM_MODEL_dual_link_H
#define EM_MODEL_dual_link_H

#include "eigenmotion.h"

/* Exported from a library, even if other symbols are hidden. */
__attribute__((visibility("default"))) extern const em_model dual_link_model;

#endif
