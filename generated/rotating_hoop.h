/* eigenmotion generate rotating_hoop.py */
/* input sha256:a672e66f4b0d29e372c07c590c827762e68aba35fb998dc3ed2bf848d498158e */
/* body sha256:8f47ef5adcfd6088575f48b4de88c2f820f4db86c33aa59c19bd3e49d211683e */
/* rotating_hoop: 1 coordinates, 0 constraint rows, 2 states.
 * Link rotating_hoop.c with a program of your own,
 * or import the Python module built from rotating_hoop.pyx. */
#ifndef EM_MODEL_rotating_hoop_H
#define EM_MODEL_rotating_hoop_H

#include "eigenmotion.h"

/* Seen from outside of a library, whatever else it hides. */
__attribute__((visibility("default"))) extern const em_model rotating_hoop_model;

#endif
