/* em_further_methods.h: the methods that no run takes by itself, a unit of their own (docs/architecture.md). */
#ifndef EM_FURTHER_METHODS_H
#define EM_FURTHER_METHODS_H

#include "em_collocation.h"
#include "em_runge_kutta.h"

/* rk34 has no second state at the end of a step. */
static int em_dopri5_judge(em_walk *w) { return em_rk_judge(&EM_DOPRI5_TABLEAU, EM_DOPRI5_STABLE, w); }

EM_RUNGE_KUTTA(rk34, EM_RK34_TABLEAU, NULL)
EM_RUNGE_KUTTA(dopri5, EM_DOPRI5_TABLEAU, em_dopri5_judge)
EM_RUNGE_KUTTA(rk4, EM_RK4_TABLEAU, NULL)
EM_RUNGE_KUTTA(midpoint, EM_MIDPOINT_TABLEAU, NULL)

static em_scheme em_collocation(const em_radau_iia *rk) {
    return (em_scheme){rk->stages, 1.0, 0.0, 8.0, rk->stages, 0, em_collocation_step, NULL, em_collocation_interpolate,
                       em_collocation_sketch, em_collocation_evaluate, EM_MOTION, 1, rk, NULL};
}

static em_scheme em_further_scheme(em_method method) {
    switch (method) {
        case EM_RK34: return em_rk34();
        case EM_DOPRI5: return em_dopri5();
        case EM_RADAU5: return em_collocation(&EM_RADAU5_TABLEAU);
        case EM_RADAU9: return em_collocation(&EM_RADAU9_TABLEAU);
        case EM_RK4: return em_rk4();
        case EM_MIDPOINT: return em_midpoint();
        default: return (em_scheme){.step = NULL};
    }
}

/* em_model.further: *scheme <- that of one of these methods. */
EM_ACROSS void em_further(em_method method, void *scheme) { *(em_scheme *)scheme = em_further_scheme(method); }

#endif
