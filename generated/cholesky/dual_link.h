/* eigenmotion generate dual_link.py --formulation cholesky */
/* input sha256:df7bb6a0e8a7ccae115ffd5a4199255e043926e1730038f5561b0029f974f77b */
/* body sha256:3cc5c96b2d738d8747dda59e00cb6ee8560ae73bda302815187dd5ff2ebcb880 */
/* dual_link: 4 coordinates, 1 constraint rows, 8 states.
 * Link dual_link.c with a program of your own,
 * or import the Python module built from dual_link.pyx. */
#ifndef EM_MODEL_dual_link_H
#define EM_MODEL_dual_link_H

#include "eigenmotion.h"

/* Visible from outside of a library, whatever else it hides. */
__attribute__((visibility("default"))) extern const em_model dual_link_model;

#endif
