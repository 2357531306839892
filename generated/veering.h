/* eigenmotion generate veering.py */
/* input sha256:78fe0b0607cb9d47c4482d62bca9597c433dd9fa918a96242e8beb80e9eda101 */
/* body sha256:757576db9851017fd7f625ab117b6dfbbeb56fc9c4160bcc9003314f0525f0e7 */
/* veering: 2 coordinates, 0 constraint rows, 10 states.
 * Link veering.c with a program of your own, or import the Python module built from veering.pyx. */
#ifndef EM_MODEL_veering_H
#define EM_MODEL_veering_H

#include "eigenmotion.h"

extern const em_model veering_model;

#endif
