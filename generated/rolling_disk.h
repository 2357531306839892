/* eigenmotion generate rolling_disk.py */
/* input sha256:6f820682dd71248bd575d4f3290b694d3dc8ce06d3020af7615979a461322499 */
/* body sha256:efd1b049d4804039747077b9306fa9aafbbf9f6c108bebc871085796dcf0b24c */
/* rolling_disk: 5 coordinates, 2 constraint rows, 40 states.
 * Link rolling_disk.c with a program of your own, or import the Python module built from rolling_disk.pyx. */
#ifndef EM_MODEL_rolling_disk_H
#define EM_MODEL_rolling_disk_H

#include "eigenmotion.h"

extern const em_model rolling_disk_model;

#endif
