/* em_stepper.c: the stepper, compiled once for all models, of which it knows what em_model says. */
#define EM_UNIT EM_STEPPER
#include "loop/em_handle.h"
#include "batch/em_lane_run.h"
