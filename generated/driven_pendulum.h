/* eigenmotion generate driven_pendulum.py */
/* input sha256:4e9893cc5e7c5dc0d481cf1470a3ef3a5e1a3b84e5f7e00dadf8b82698fb15df */
/* body sha256:170511dd9fa6be8c5ee1cef709b9c25d4882978200cfe3abde7ea7d62df810c7 */
/* driven_pendulum: 2 coordinates, 1 constraint rows, 4 states.
 * Link driven_pendulum.c with a program of your own,
 * or import the Python module built from driven_pendulum.pyx. */
#ifndef EM_MODEL_driven_pendulum_H
#define EM_MODEL_driven_pendulum_H

#include "eigenmotion.h"

/* Seen from outside of a library, whatever else it hides. */
__attribute__((visibility("default"))) extern const em_model driven_pendulum_model;

#endif
