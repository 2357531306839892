/* eigenmotion generate rolling_disk.py */
/* input sha256:69b429562514b50858c0b118c3d9597a64cb5241030b49682b16eacf16c7db02 */
/* body sha256:3740cd8bb63925d0c6f3056cadbb1dbba3f873ab6fd67a243faf2ab06d479e68 */
/* rolling_disk: 5 coordinates, 2 constraint rows, 40 states.
 * Link rolling_disk.c with a program of your own,
 * or import the Python module built from rolling_disk.pyx. */
#ifndef EM_MODEL_rolling_disk_H
#define EM_MODEL_rolling_disk_H

#include "eigenmotion.h"

extern const em_model rolling_disk_model;

#endif
