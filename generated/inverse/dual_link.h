/* eigenmotion generate dual_link.py --formulation inverse */
/* input sha256:1093f8d0de759d8d08dc9d63d3112a5f4c2f8bfe33f09048d1984c6e4a0efdf7 */
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
