/* eigenmotion generate rolling_disk.py */
/* input sha256:54f552f8bf8eaf402fe74f441e34761761c25ec8db4dad6aa08f8e7416ea6409 */
/* body sha256:b3d6a5e71a5e9aedd44b600ebb61fadca12f686fd28fcf3dacae9b42e9585833 */
/* rolling_disk: 5 coordinates, 2 constraint rows, 40 states.
 * Link rolling_disk.c with a program of your own,
 * or import the Python module built from rolling_disk.pyx. */
#ifndef EM_MODEL_rolling_disk_H
#define EM_MODEL_rolling_disk_H

#include "eigenmotion.h"

/* Exported from a library, even if other symbols are hidden. */
__attribute__((visibility("default"))) extern const em_model rolling_disk_model;

#endif
