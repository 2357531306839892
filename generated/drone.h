/* eigenmotion generate drone.py */
/* input sha256:54ce1e572a6e83c71b949c868f9ca891676ab1d2e981f80cbcd282ef5642bbe9 */
/* body sha256:0232f4919b4dbc31f84e769de81b7c4f43526f1c96c4ee813c20c4e7826c2b79 */
/* drone: 8 coordinates, 0 constraint rows, 58 states.
 * Link drone.c with a program of your own, or import the Python module built from drone.pyx. */
#ifndef EM_MODEL_drone_H
#define EM_MODEL_drone_H

#include "eigenmotion.h"

extern const em_model drone_model;

#endif
