/* eigenmotion generate dual_link.py --formulation cholesky */
/* input sha256:df7bb6a0e8a7ccae115ffd5a4199255e043926e1730038f5561b0029f974f77b */
/* body sha256:e2d083f3ddbbc4b40ea0c2b38384b875ea7aaa81a07fa9b65b231e659254b24f */
/* dual_link: 4 coordinates, 1 constraint rows, 8 states.
 * Link dual_link.c with a program of your own,
 * or import the Python module built from dual_link.pyx. */
#ifndef EM_MODEL_dual_link_H
#define EM_MODEL_dual_link_H

#include "eigenmotion.h"

/* Seen from outside of a library, whatever else it hides. */
__attribute__((visibility("default"))) extern const em_model dual_link_model;

#endif
