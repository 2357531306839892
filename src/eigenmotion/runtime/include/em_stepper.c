/* em_stepper.c: the stepper, compiled once for all models; it uses a model only through em_model. */
#define EM_UNIT EM_STEPPER
#include "bodies/em_articulated_bodies.h"
#include "bodies/em_recursions.h"
#include "bodies/em_tree_partials.h"
#include "dynamics/em_blocks.h"
#include "loop/em_handle.h"
#include "batch/em_lane_run.h"
#include "inverse_dynamics/em_inverse_dynamics.h"
