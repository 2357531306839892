/* eigenmotion generate compass_gait.py */
/* input sha256:16b28dc5eef92bb460ce2a92b01dd77a52ef651273d117ec32a4c6820b543912 */
/* body sha256:01eaa10bf42eb1b5ba58a7dbcd0f039b8c1acc4f2bb123d9e77f987b5164d244 */
/* compass_gait: 2 coordinates, 0 constraint rows, 10 states.
 * Link compass_gait.c with a program of your own,
 * or import the Python module built from compass_gait.pyx. */
#ifndef EM_MODEL_compass_gait_H
#define EM_MODEL_compass_gait_H

#include "eigenmotion.h"

extern const em_model compass_gait_model;

#endif
