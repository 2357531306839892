/* em_variations.h: sensitivities of a motion to its start, parameters and inputs, by the variational equations.
 *
 *     d/dt dx = dv,   d/dt dv = a_x dx + a_v dv + a_p dp
 *
 * along a run, of any em_model, that keeps its dense output. These equations have steps of their own, as long as their
 * own error allows (em_variation_error.h): the steps of a motion at rest say nothing about how fast others diverge from
 * it. After each step the directions are projected onto the tangent of the constraints. Where a force jumps there must
 * be an event, across which directions jump, too. */
#ifndef EM_VARIATIONS_H
#define EM_VARIATIONS_H

#include "loop/em_subnormals.h"
#include "sensitivity/em_variation_events.h"

/* Integrates over a span which has been entered. within: 0, or the time that cones that stop at `stop` need from the
 * slip of their events to zero: on the way their stops are predicted. */
static int em_cross_span(em_pass *p, size_t span, double stop, double within) {
    const em_variations *const w = p->of;
    const double to = w->to[span], length = fabs(to - w->from[span]);
    double t = w->from[span], ahead = fmin(fmin(EM_CONE_MOST * within, sqrt(within * length)), 0.5 * length);
    for (; within > 0.0 && ahead >= EM_CONE_LEAST * within; ahead /= EM_CONE_RATIO) {
        const double pause = stop - w->direction * ahead;
        if (em_advance_to(p, t, pause) || em_predict_cone_stops(p, pause, stop - pause)) return -1;
        t = pause;
    }
    return em_advance_to(p, t, to);
}

/* Integrates over the spans between two stops, at a distance `margin` from stops at which events happen. */
static int em_variation_segment(em_pass *p, size_t stop, size_t *span, int leaves, int meets, double margin) {
    em_variations *const w = p->of;
    em_begin_cone_stops(p);
    em_pass_pieces(p, w->t[stop]);
    em_pass_side(p, w->t[stop], fabs(margin), 1);
    if (leaves && em_extrapolate_directions(p, w->t[stop], margin)) return -1;
    for (long i = 0; i < w->spans[stop]; ++i, ++*span) {
        if (em_enter_span(p, *span)) return -1;
        const double within = i + 1 < w->spans[stop] || !meets ? 0.0 : em_cones_stop_within(p, stop + 1);
        if (em_cross_span(p, *span, w->t[stop + 1], fmax(within > 0.0 ? fabs(margin) : 0.0, within))) return -1;
    }
    memcpy(p->z, w->z + (stop + 1) * 2 * p->n, 2 * p->n * sizeof *p->z);
    return meets ? em_extrapolate_directions(p, w->t[stop + 1] - margin, margin) : 0;
}

static int em_is_marked(const em_variations *w, size_t mark, size_t stop) {
    return mark < w->n_marks && w->mark_stop[mark] == (long)stop;
}

static int em_variation_stops(em_pass *p) {
    em_variations *const w = p->of;
    size_t mark = 0, span = 0;
    double margin = 0.0;
    int leaves = 0;
    for (size_t stop = 0; stop < w->n_stops; ++stop) {
        const int more = stop + 1 < w->n_stops, meets = em_is_marked(w, mark, stop);
        const double length = more ? w->t[stop + 1] - w->t[stop] : 0.0;
        if (em_keep_at_stop(p, stop)) return -1;
        const int acted = meets ? em_variation_marks(p, stop, &mark, margin != 0.0 ? margin : EM_EVENT_MARGIN * length) : 0;
        if (acted < 0) return -1;
        leaves |= meets;
        if (acted || !more) continue; /* the next stop is the state after this one's actions */
        if (meets && em_keep_at_stop(p, stop)) return -1;
        margin = EM_EVENT_MARGIN * length;
        if (em_variation_segment(p, stop, &span, leaves, em_is_marked(w, mark, stop + 1), margin)) return -1;
        leaves = 0;
    }
    return 0;
}

/* Allocates the memory of a pass and lays out its parts. 0, or -1. */
static int em_pass_open(em_pass *p, em_variations *w) {
    enum { NODES = EM_VARIATION_NODES };
    const em_model *const model = w->model;
    const int n = model->n, m = model->m, k = w->columns / 4 * 4 + 4, size = NODES * n;
    *p = (em_pass){.of = w, .n = n, .m = m, .columns = k, .wide = EM_IS_WIDE,
                   .inside = {-INFINITY, INFINITY}};
    const struct {
        double **part;
        size_t count;
    } parts[] = {
        {&p->S, 2 * n * k}, {&p->z, 2 * n}, {&p->P, w->n_forcing * k}, {&p->u, model->n_inputs}, {&p->a, size}, {&p->lambda, m},
        {&p->dlambda, m * model->n_arguments}, {&p->c, model->n_prepared}, {&p->J, size * model->n_arguments},
        {&p->L, (size_t)size * (size + k)}, {&p->K, size * k}, {&p->G, size * k}, {&p->Y, 2 * n * k},
        {&p->W, (size + m) * k}, {&p->Z, 2 * size}, {&p->off, 2 * size}, {&p->S0, 2 * n * k}, {&p->K0, n * k},
        {&p->J0, n * model->n_arguments}, {&p->a0, n}, {&p->T0, n * k}, {&p->T, n * k},
        {&p->K_rounding, n * k}, {&p->a_rounding, n}, {&p->units, n}, {&p->B, n * n}, {&p->y, model->n_state},
        {&p->predictions, 2 * model->n_switches * k}, {&p->shift, n * k}, {&p->drive0, n}, {&p->drive, size}, {&p->jerk, size + n},
        {&p->M, n * n}, {&p->shift_error, 2 * n},
    };
    enum { PARTS = sizeof parts / sizeof *parts };
    size_t numbers = 1;
    for (int i = 0; i < PARTS; ++i) numbers += parts[i].count;
    double *next = calloc(numbers, sizeof *next);
    p->piece = calloc(model->n_inputs + 1, sizeof *p->piece);
    p->pile = calloc(model->n_events + 1, sizeof *p->pile);
    p->rows = calloc(size, sizeof *p->rows);
    p->of_stops = calloc(model->n_switches + 1, sizeof *p->of_stops);
    p->nonzeros = calloc(w->n_forcing * k, sizeof *p->nonzeros);
    p->S = next;
    if (!next || !p->piece || !p->pile || !p->rows || !p->nonzeros || !p->of_stops) return em_fail(&w->fault, EM_OUT_OF_MEMORY, -1, -1, 0.0);
    for (int i = 0; i < PARTS; ++i) *parts[i].part = next, next += parts[i].count;
    for (int s = 0; s < model->n_switches; ++s)
        p->of_stops[s] = (em_cone_stop){p->predictions + 2 * s * k, p->predictions + (2 * s + 1) * k, INFINITY};
    return 0;
}

static void em_pass_close(em_pass *p) {
    free(p->S);
    free(p->piece);
    free(p->pile);
    free(p->rows);
    free(p->nonzeros);
    free(p->of_stops);
}

/* Lists the non-zero entries of P, apart from the last column. */
static void em_find_nonzeros(em_pass *p) {
    for (int i = 0; i < p->of->n_forcing; ++i)
        for (int j = 0; j < p->of->columns; ++j)
            if (p->P[i * p->columns + j] != 0.0) p->nonzeros[p->n_nonzeros][0] = i, p->nonzeros[p->n_nonzeros++][1] = j;
}

/* The weights of a series at the start of a step. */
static void em_find_origin(em_pass *p) {
    enum { NODES = EM_VARIATION_NODES };
    for (int d = 0; d < NODES; ++d)
        for (int j = 0; j < NODES; ++j) p->origin[j] += (d % 2 ? -1.0 : 1.0) * p->of->series[d * NODES + j];
}

/* Initialises a pass at its first stop. 0, or -1. */
static int em_pass_begin(em_pass *p, em_variations *w) {
    w->fault = (em_fault){EM_FINISHED, -1, -1, 0.0};
    w->why = EM_BY_FAULT;
    if (em_pass_open(p, w)) return -1;
    const int n = p->n, k = p->columns, requested = w->columns;
    memcpy(p->c, w->c, w->model->n_prepared * sizeof *w->c);
    memcpy(p->z, w->z, 2 * n * sizeof *w->z);
    for (int i = 0; i < w->n_forcing; ++i) memcpy(p->P + i * k, w->P + i * requested, requested * sizeof *w->P);
    p->P[(w->n_forcing - 1) * k + k - 1] = 1.0;
    em_find_nonzeros(p);
    em_find_origin(p);
    for (int i = 0; w->S && i < 2 * n; ++i) memcpy(p->S + i * k, w->S + i * requested, requested * sizeof *w->S);
    em_pass_pieces(p, w->t[0]);
    return 0;
}

static int em_pass_integrate(em_pass *p) {
    const uint64_t subnormals = em_flush_subnormals();
    const int status = em_variation_stops(p);
    em_restore_subnormals(subnormals);
    return status;
}

/* S <- at all stops and rows. 0, or -1 and w->fault, w->why; stops and rows that were not reached are untouched. */
static int em_integrate_variations(em_variations *w) {
    em_pass pass;
    int status = em_pass_begin(&pass, w);
    if (status == 0) status = em_pass_integrate(&pass);
    em_pass_close(&pass);
    return status;
}

#endif
