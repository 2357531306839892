/* eigenmotion generate dual_link.py */
/* input sha256:52bc551d5b2773d73d71f334f6d9132d9fb29767b93531fe091340a7ab1e18af */
/* body sha256:d266cd900acba69ba16ca8b0be640259eecf81889940ef5f92faf68dc2f762f9 */
/* dual_link: 4 coordinates, 1 constraint rows, 20 states.
 * Link dual_link.c with a program of your own, or import the Python module built from dual_link.pyx. */
#ifndef EM_MODEL_dual_link_H
#define EM_MODEL_dual_link_H

#include "eigenmotion.h"

extern const em_model dual_link_model;

#endif
