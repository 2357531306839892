/* eigenmotion generate newtons_cradle.py */
/* input sha256:b7b2f2f815633c0c13ec47b71b8d50d30eeb9cbde0c35a3d76e313769a9245db */
/* body sha256:4fdf020dade497e71f35e8f02d6b86654456f77c9c8dbb827124422076a2c761 */
/* newtons_cradle_4: 4 coordinates, 0 constraint rows, 8 states.
 * Link newtons_cradle_4.c with a program of your own,
 * or import the Python module built from newtons_cradle_4.pyx. */
#ifndef EM_MODEL_newtons_cradle_4_H
#define EM_MODEL_newtons_cradle_4_H

#include "eigenmotion.h"

/* Seen from outside of a library, whatever else it hides. */
__attribute__((visibility("default"))) extern const em_model newtons_cradle_4_model;

#endif
