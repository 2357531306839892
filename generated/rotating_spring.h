/* eigenmotion generate rotating_spring.py */
/* input sha256:9fd001e04d700e24247c3d43938cdd83f0c561fb68403918e37258e6c68b23c2 */
/* body sha256:5b4508f99c8d45d0d1867e7450d220511746f2fe9d66619ba894dfc48e8852cd */
/* rotating_spring: 2 coordinates, 0 constraint rows, 4 states.
 * Link rotating_spring.c with a program of your own,
 * or import the Python module built from rotating_spring.pyx. */
#ifndef EM_MODEL_rotating_spring_H
#define EM_MODEL_rotating_spring_H

#include "eigenmotion.h"

extern const em_model rotating_spring_model;

#endif
