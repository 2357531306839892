/* eigenmotion generate dual_link.py --formulation lagrange */
/* input sha256:7b059552c245cdd53260302a22a4501c7fbc28c7ec192ef324b592c3c23ccf18 */
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
