/* em_dense_output.h: dense output: the state inside a step, settled like accepted states.
 *
 * The interpolant belongs to the unsettled step: it joins y and y_raw with the right-hand sides there, in the mode
 * of the step's start. Settling its values makes the trajectory continuous with the accepted states. */
#ifndef EM_DENSE_OUTPUT_H
#define EM_DENSE_OUTPUT_H

#include "methods/em_methods.h"

/* y, memory <- the settled state at t inside the current step, in the mode of its start. */
static int em_settled_state_at(em_run_state *w, double t, double *y, double *memory) {
    int mode = w->mode;
    w->scheme.evaluate(w->n_state, w->F[0], w->scheme.terms, (t - w->t) / w->h, y);
    em_copy_memory(w, memory, w->memory);
    return em_settle(w->model, w->run, &mode, EM_KEEP_MODE, em_clock(w, t), y, memory, t - w->t, &w->reason) < 0 ? -1 : 0;
}

/* em_model.interpolate: y (n_state) at t from the kept step number `step`, settled and published. 0, or -1. */
EM_EXPORT int em_interpolate(const em_model *model, const em_run *run, size_t step, double t, double *y) {
    const em_dense_step *at = &run->dense_steps[step];
    const double *F = run->dense_table + step * EM_DENSE_COEFFICIENTS * (size_t)model->n_state;
    double inside[model->n_state], memory[em_padded(model->dynamics->n_memory)];
    const em_scheme scheme = em_scheme_of(at->method);
    em_fault fault;
    em_run then;
    int mode = at->mode;
    if (at->segment > 0) then = *run, then.prepared = run->segments.y + (at->segment - 1) * run->segments.width, run = &then;
    memset(memory, 0, sizeof memory);
    scheme.evaluate(model->n_state, F, scheme.terms, (t - at->t) / at->h, inside);
    if (em_settle(model, run, &mode, EM_KEEP_MODE | at->kept, t, inside, memory, t - at->t, &fault) < 0) return -1;
    return em_publish(model, run, mode, t, inside, memory, y, &fault);
}

#endif
