/* eigenmotion generate dual_link.py */
/* input sha256:265d8892a5a4b7aeb90d2a04585617a209d831a7a9ea64b4efac5e5060f02063 */
/* body sha256:be77e4f305b433ed3aaba9df0212d38ffd548fba33d47573b76a8e9a66d29016 */
/* dual_link: 4 coordinates, 1 constraint rows, 20 states.
 * Link dual_link.c with a program of your own,
 * or import the Python module built from dual_link.pyx. */
#ifndef EM_MODEL_dual_link_H
#define EM_MODEL_dual_link_H

#include "eigenmotion.h"

/* Visible from outside of a library, whatever else it hides. */
__attribute__((visibility("default"))) extern const em_model dual_link_model;

#endif
