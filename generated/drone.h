/* eigenmotion generate drone.py */
/* input sha256:03661c6d20f5a8cb88cd034f411466fa0dcf11c1fb135347a853d98d37b52765 */
/* body sha256:0232f4919b4dbc31f84e769de81b7c4f43526f1c96c4ee813c20c4e7826c2b79 */
/* drone: 8 coordinates, 0 constraint rows, 58 states.
 * Link drone.c with a program of your own, or import the Python module built from drone.pyx. */
#ifndef EM_MODEL_drone_H
#define EM_MODEL_drone_H

#include "eigenmotion.h"

extern const em_model drone_model;

#endif
