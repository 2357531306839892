/* eigenmotion generate dual_link.py --formulation cholesky */
/* input sha256:ee6f21131ce26700b20eff2c6c1d1414598ccb2d41634016406f7e75ca1151d6 */
/* body sha256:ce0351c853d180c4e3f3572d7df72f9968f16e402b9edc8d29a05bbf7efd3eea */
/* dual_link: 4 coordinates, 1 constraint rows, 8 states.
 * Link dual_link.c with a program of your own,
 * or import the Python module built from dual_link.pyx. */
#ifndef EM_MODEL_dual_link_H
#define EM_MODEL_dual_link_H

#include "eigenmotion.h"

/* Exported from a library, even if other symbols are hidden. */
__attribute__((visibility("default"))) extern const em_model dual_link_model;

#endif
