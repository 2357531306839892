/* em_methods.h: the table of methods: how each makes a step and evaluates the states within it (em_scheme of
 * em_run_state.h).
 *
 * A new kind of method needs a header next to em_runge_kutta.h with its functions, a number in em_method of em_run.h,
 * and a line below; arguments/methods.py is the table for Python. */
#ifndef EM_METHODS_H
#define EM_METHODS_H

#include "radau_iia/em_collocation.h"
#include "gauss_radau/em_node_interpolant.h"
#include "gauss_radau/em_gauss_radau.h"
#include "methods/em_runge_kutta.h"

/* rk34 has no second state at the end of a step, and so no test of stiffness. */
static int em_dopri5_judge(em_run_state *w) { return em_rk_judge(&EM_DOPRI5_TABLEAU, EM_DOPRI5_STABLE, w); }
static int em_dop853_judge(em_run_state *w) { return em_rk_judge(&EM_DOP853_TABLEAU, EM_DOP853_STABLE, w); }

EM_RUNGE_KUTTA(rk34, EM_RK34_TABLEAU, NULL)
EM_RUNGE_KUTTA(dopri5, EM_DOPRI5_TABLEAU, em_dopri5_judge)
EM_RUNGE_KUTTA(dop853, EM_DOP853_TABLEAU, em_dop853_judge)
EM_RUNGE_KUTTA(rk4, EM_RK4_TABLEAU, NULL)
EM_RUNGE_KUTTA(midpoint, EM_MIDPOINT_TABLEAU, NULL)

static em_scheme em_ra15(void) {
    return (em_scheme){{EM_STEP_SIZE_ORDER, 1.0, 0.3, 3.0}, EM_NODE_COUNT + 1, 0, em_nodes_step, em_nodes_judge,
                       em_nodes_interpolate, em_nodes_sketch, em_nodes_evaluate, 0, 0, NULL, em_nodes_within, 1};
}

static em_scheme em_collocation(const em_radau_iia *rk, int (*step)(em_run_state *w)) {
    return (em_scheme){{rk->stages, 1.0, 0.0, 8.0}, rk->stages, 0, step, NULL, em_collocation_interpolate,
                       em_collocation_sketch, em_collocation_evaluate, EM_MOTION, 1, rk, NULL, 0};
}

/* The table; an entry without a step: there is no such method. */
static em_scheme em_scheme_of(em_method method) {
    switch (method) {
        case EM_RK34: return em_rk34();
        case EM_DOPRI5: return em_dopri5();
        case EM_DOP853: return em_dop853();
        case EM_RA15: return em_ra15();
        case EM_RK4: return em_rk4();
        case EM_MIDPOINT: return em_midpoint();
        case EM_RADAU5: return em_collocation(&EM_RADAU5_TABLEAU, em_radau5_step);
        case EM_RADAU9: return em_collocation(&EM_RADAU9_TABLEAU, em_radau9_step);
        default: return (em_scheme){.step = NULL};
    }
}

#endif
