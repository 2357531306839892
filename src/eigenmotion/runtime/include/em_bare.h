/* em_bare.h: in place of em_guard.h and em_chart.h where a model gives its right-hand side and no terms of its equations
 * (em_mechanics.h), as one written by hand may: there is nothing to hold a step against. */
#ifndef EM_BARE_H
#define EM_BARE_H

#include "em_blame.h"

EM_RARE static int em_fail_weakest(em_walk *w, double size) {
    em_fail(&w->reason, EM_DEPENDENT_CONSTRAINTS, -1, -1, size);
    return em_blame(w, w->t_new, w->y_new);
}

static int em_shares(em_walk *w) { return w->asked == EM_SHARED ? EM_SHARED : EM_REFUSED; }
static int em_keep_constraints(em_walk *w, double t, const double *x) { return (void)w, (void)t, (void)x, 0; }
static int em_keep_constraints_at_start(em_walk *w) { return (void)w, 0; }
static int em_check_dependent(em_walk *w) { return (void)w, 0; }
static int em_check_positions(em_walk *w) { return (void)w, 0; }
static int em_check_drift(em_walk *w, const double *x, const double *v) { return (void)w, (void)x, (void)v, 0; }
static int em_check_factors(em_walk *w) { return (void)w, 0; }
static void em_begin_chart(em_walk *w) { (void)w; }
static int em_check_chart(em_walk *w) { return (void)w, 0; }

#endif
