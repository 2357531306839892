/* eigenmotion generate rotating_spring.py */
/* input sha256:eececf7da8524af92b5fbfbe220e13e1ff2df8274451addce864432085de9820 */
/* body sha256:06de3fdf8869aa1c0eb9a5e8e0acb9363f0de6069d29b1161199a47b49792405 */
/* rotating_spring: 2 coordinates, 0 constraint rows, 4 states.
 * Link rotating_spring.c with a program of your own,
 * or import the Python module built from rotating_spring.pyx. */
#ifndef EM_MODEL_rotating_spring_H
#define EM_MODEL_rotating_spring_H

#include "eigenmotion.h"

/* Seen from outside of a library, whatever else it hides. */
__attribute__((visibility("default"))) extern const em_model rotating_spring_model;

#endif
