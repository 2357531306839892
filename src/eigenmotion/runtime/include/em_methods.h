/* em_methods.h: the methods, as the stepper asks them for a step and for the states within it (em_scheme of em_walk.h).
 *
 * Here a method of another kind finds its place: a header beside em_runge_kutta.h with its four functions, a number in
 * em_method of em_run.h and a line below; running/methods.py is the table for Python. What method="auto" takes is here,
 * compiled with every stepper; the others are in em_further_methods.h, a unit of their own.
 */
#ifndef EM_METHODS_H
#define EM_METHODS_H

#include "em_node_interpolant.h"
#include "em_nodes.h"
#include "em_runge_kutta.h"

static int em_dop853_judge(em_walk *w) { return em_rk_judge(&EM_DOP853_TABLEAU, EM_DOP853_STABLE, w); }

EM_RUNGE_KUTTA(dop853, EM_DOP853_TABLEAU, em_dop853_judge)

static em_scheme em_ra15(void) {
    return (em_scheme){EM_SIZES_ORDER, 1.0, 0.3, 3.0, EM_NODE_COUNT + 1, 0, em_nodes_step, em_nodes_judge,
                       em_nodes_interpolate, em_nodes_sketch, em_nodes_evaluate, 0, 0, NULL, em_nodes_within};
}

#if EM_HOLDS(EM_METHODS)
#include "em_further_methods.h"
#endif

/* The table: here what every run may take, and the others where they are; without a step: they are not. */
static em_scheme em_scheme_of(EM_UNUSED const em_model *model, em_method method) {
    em_scheme scheme = {.step = NULL};
    switch (method) {
        case EM_DOP853: return em_dop853();
        case EM_RA15: return em_ra15();
        default: break;
    }
#if EM_HOLDS(EM_METHODS)
    scheme = em_further_scheme(method);
#else
    if (model != NULL && model->further != NULL) model->further(method, &scheme);
#endif
    return scheme;
}

#endif
