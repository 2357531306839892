/* eigenmotion generate rolling_disk.py */
/* input sha256:79152ce9a70780f4325278032ef1389f2d102285d0e7bce6c3bcb5c1a5a4850c */
/* body sha256:9bade806ea0db4415482019d39683cb375b8f0af42c6ea3d822d7c3ab478571f */
/* rolling_disk: 5 coordinates, 2 constraint rows, 40 states.
 * Link rolling_disk.c with a program of your own,
 * or import the Python module built from rolling_disk.pyx. */
#ifndef EM_MODEL_rolling_disk_H
#define EM_MODEL_rolling_disk_H

#include "eigenmotion.h"

/* Visible from outside of a library, whatever else it hides. */
__attribute__((visibility("default"))) extern const em_model rolling_disk_model;

#endif
