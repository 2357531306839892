/* eigenmotion generate newtons_cradle.py */
/* input sha256:d03fffd6f0b1f4e84fea167ae4c5a20d5a9d871dbd52e74b346227dc71006e77 */
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
