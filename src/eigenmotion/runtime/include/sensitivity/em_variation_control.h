/* em_variation_control.h: step-size control of the variational equations, by their own error. */
#ifndef EM_VARIATION_CONTROL_H
#define EM_VARIATION_CONTROL_H

#include "sensitivity/em_derivative_tape.h"

#define EM_MOST_LENGTH 2.0 /* bound on the length of a step here, relative to initial_steps: features that the run has
                              resolved matter */
#define EM_LEAST_CUT 0.6   /* the smallest part of its length to which a step is cut to end with a step of the run */
#define EM_FEW_STEPS 3.0   /* steps of a way, of which one is worth saving */
#define EM_STRETCH 1.1     /* of the length that an error suggests: the error stays below one, if it is as predicted */
#define EM_AT_ROW 1e-6     /* of a step: a row that is nearer to its start is there */
#define EM_NO_STEP 1e-2    /* of a step: a part that is not worth a step of its own */
#define EM_MOTION_ITERATIONS 4     /* iterations of Newton's method for a step's own motion */
#define EM_JUMP_TOLERANCES 100.0   /* in tolerances: apparent jumps of the accelerations of a smooth motion */
#define EM_MOST_STEPS_OF_SPAN 1e7  /* progress: a span that needs more steps of the current length is given up */

enum { EM_END_POWER = 14, EM_WITHIN_POWER = 10 }; /* the errors of a step, as powers of its length */

enum { EM_MOST_LEAST = 200 /* successive steps of the smallest length */, EM_MOST_CRAWLING = 10000 };

static int em_is_finite(size_t count, const double *a) {
    for (size_t i = 0; i < count; ++i)
        if (!isfinite(a[i])) return 0;
    return 1;
}

EM_FOR_AVX2 static int em_step_wide(em_pass *p, double h) { return em_step_directions(p, h); }
static int em_step_narrow(em_pass *p, double h) { return em_step_directions(p, h); }
EM_FOR_AVX2 static em_step_errors em_error_wide(em_pass *p, double h, const double *K_rounding) {
    return em_step_error(p, h, K_rounding);
}
static em_step_errors em_error_narrow(em_pass *p, double h, const double *K_rounding) { return em_step_error(p, h, K_rounding); }
EM_FOR_AVX2 static em_step_errors em_forcing_error_wide(em_pass *p) { return em_forcing_error(p); }
static em_step_errors em_forcing_error_narrow(em_pass *p) { return em_forcing_error(p); }
EM_INLINE void em_begin_rates(em_pass *p) {
    em_rates_of(p, p->J0, p->S0, p->K0);
    em_sum_terms(p, p->J0, p->S0, p->T0);
    if (em_has_shifts(p)) em_add_rates_of_shifts(p, p->J0, p->drive0, p->z + p->n, p->a0, p->K0);
}
EM_FOR_AVX2 static void em_begin_wide(em_pass *p) { em_begin_rates(p); }
static void em_begin_narrow(em_pass *p) { em_begin_rates(p); }

/* S0 <- S, the directions at the start of a step at t, with z, a0, J0 known. */
static void em_begin_step(em_pass *p, double t) {
    const int n = p->n, k = p->columns;
    if (p->tape) em_set_local_probes(p, t);
    for (int i = 0; i < 2 * n; ++i) p->S[i * k + k - 1] = 0.0;
    memcpy(p->S0, p->S, 2 * (size_t)n * k * sizeof *p->S0);
    memset(p->shift, 0, (size_t)n * k * sizeof *p->shift);
    p->apart = 0;
    if (!p->tape) p->of->model->mass_matrix(em_pass_clock(p, t), p->z, p->c, p->M);
}

/* K and S of a step whose motion is known, S0 and K0 without the shifts. 0, or 1: there is no solution. */
static int em_solve_rest(em_pass *p, double h) {
    if (em_has_shifts(p)) em_add_shifts(p, -1.0, p->z + p->n, p->a0, p->S0);
    (p->wide ? em_begin_wide : em_begin_narrow)(p);
    return (p->wide ? em_step_wide : em_step_narrow)(p, h) ? 1 : 0;
}

/* The same, with the shifts of which the step, and the one before, have been certain. `jump` (2 n): em_shift_error. */
static int em_solve_directions(em_pass *p, double h, const double *jump) {
    const double *const v = p->z + p->n;
    double whole[p->columns];
    if (p->tape) return em_solve_rest(p, h);
    if (em_has_shifts(p)) em_add_shifts(p, 1.0, v, p->a0, p->S0);
    memset(p->shift, 0, (size_t)p->n * p->columns * sizeof *p->shift);
    if (!em_project_on_motion(p, h, whole)) return em_solve_rest(p, h);
    em_sum_terms(p, p->J0, p->S0, p->T0);
    em_shift_coordinates(p, h, whole);
    em_forget_shifts(p, h);
    if (em_solve_rest(p, h)) return 1;
    em_find_jerk(p);
    em_shift_error(p, h, jump, p->shift_error);
    const size_t size = 2 * (size_t)p->n * p->columns * sizeof *p->S0;
    memcpy(p->Y, p->S0, size);
    em_add_shifts(p, 1.0, v, p->a0, p->S0);
    if (em_forget_shifts(p, h)) return em_solve_rest(p, h);
    memcpy(p->S0, p->Y, size);
    return 0;
}

/* Begins a span at t: the state of the motion, a0, J0, and the rest. */
static int em_begin_span(em_pass *p, double t) {
    em_variations *const w = p->of;
    if (em_recorded_motion(p, t, p->z)) return -1;
    em_pass_inputs(p, t);
    if (w->model->motion_derivatives(em_pass_clock(p, t), p->z, p->z + p->n, p->c, p->u, w->least_norm, p->a0, p->lambda, p->J0,
                                     p->dlambda, &w->fault)) return -1;
    em_drive_of(p, p->J0, p->drive0);
    return 0;
}

/* Whether a step of the run ends at t, where its motion is most accurate. */
static int em_is_run_step_end(const em_run *run, double t) {
    return t == run->dense_steps[em_dense_at(run, t)].t || t == run->t_reached;
}

/* Computes K and S along the motion of the run within a step; if that is too inaccurate, along the step's own motion.
 * 0; 1: there is no solution; -1: a fault. */
static int em_solve_step(em_pass *p, double from, double to) {
    const double h = to - from;
    const int n = p->n;
    const double *const end = p->Z + (EM_VARIATION_NODES - 1) * 2 * n;
    double of_run[2 * n], jump[2 * n];
    p->own_motion = 0;
    if (p->tape && em_begin_step_on_tape(p)) return -1;
    for (int j = 0; j < EM_VARIATION_NODES; ++j)
        if (em_recorded_motion(p, em_node_time(p, from, to, j), p->Z + j * 2 * n)) return -1;
    memcpy(of_run, end, sizeof of_run);
    const int returns = em_is_run_step_end(p->of->run, to);
    for (int round = 0;; ++round) {
        if (em_node_jacobians(p, from, to)) return round > 0 ? 1 : -1;
        const double off = em_motion_error(p, h);
        for (int i = 0; i < 2 * n; ++i) jump[i] = returns ? of_run[i] - end[i] : 0.0;
        if (em_solve_directions(p, h, jump)) return 1;
        if (off <= EM_MOTION_ERROR) return 0;
        if (round == EM_MOTION_ITERATIONS) return 1;
        p->own_motion = 1;
        em_correct_motion(p, h);
        if (!em_is_finite(2 * (size_t)n * EM_VARIATION_NODES, p->Z)) return 1;
    }
}

/* z, a0, J0, drive0 <- at the end of a step: of the run, where it is most accurate. */
static int em_end_motion(em_pass *p, double to) {
    em_variations *const w = p->of;
    const int n = p->n, last = EM_VARIATION_NODES - 1, width = w->model->n_arguments;
    memcpy(p->J0, p->J + last * n * width, (size_t)n * width * sizeof *p->J0);
    memcpy(p->a0, p->a + last * n, n * sizeof *p->a0);
    memcpy(p->drive0, p->drive + last * n, n * sizeof *p->drive0);
    memcpy(p->z, p->Z + last * 2 * n, 2 * n * sizeof *p->z);
    if (!p->own_motion || !em_is_run_step_end(w->run, to)) return 0;
    double rate[2 * n];
    if (em_recorded_motion(p, to, p->z) || em_motion_rate(p, to, p->z, rate)) return -1;
    memcpy(p->a0, rate + n, n * sizeof *p->a0);
    return 0;
}

/* Accepts a step: its rows, and the initial data of the next. */
static int em_keep_step(em_pass *p, double from, double to) {
    em_variations *const w = p->of;
    const int n = p->n;
    const double *const v = p->z + n;
    const size_t first = p->row;
    em_step_rows(p, from, to);
    if (p->tape && em_append_step(p, from, to, first, p->row)) return -1;
    w->n_own_motion += p->own_motion;
    if (!em_is_finite(2 * (size_t)n * p->columns, p->S)) return em_fail(&w->fault, EM_NON_FINITE_STATE, -1, -1, NAN);
    if (em_end_motion(p, to)) return -1;
    em_add_shifts(p, 1.0, v, p->a0, p->S);
    if (w->stabilise && w->model->m) {
        if (p->tape && em_append_tangent(p, em_pass_clock(p, to), p->z)) return -1;
        if (w->model->tangent(em_pass_clock(p, to), p->z, v, p->c, w->least_norm, p->columns, p->S, p->P, &w->fault)) return -1;
    }
    if (!p->tape) em_end_row(p, first, to);
    w->t_reached = to;
    return ++w->n_steps % 64 == 0 && w->poll && w->poll(w->poll_argument) ? em_fail(&w->fault, EM_INTERRUPTED, -1, -1, 0.0) : 0;
}

/* Whether after a step to t as few steps lead to `last` as can, none longer than `length`. */
static int em_is_on_the_way(const em_pass *p, double from, double last, double length, double t) {
    const double done = p->of->direction * (t - from), rest = fabs(last - from), parts = ceil(rest / length);
    return done <= length && done >= rest - (parts - 1.0) * length && done >= EM_LEAST_CUT * rest / parts;
}

/* The length of steps over the rest of a way: longer than their error suggests, where that saves one of few. */
static double em_stretched(double length, double rest, double most) {
    const double parts = ceil(rest / length) - 1.0, longer = rest / parts;
    return (parts >= 1.0 && parts < EM_FEW_STEPS) && longer <= fmin(EM_STRETCH * length, most) ? longer : length;
}

/* The end of the next step to `last`, of about this length: the end of a step of the run, if one is nearly as far. The
 * nearest to an even part of the rest is taken, if it costs no more steps. */
static double em_end_towards(const em_pass *p, double from, double last, double suggested, double most) {
    const em_run *const run = p->of->run;
    const double rest = fabs(last - from), length = em_stretched(suggested, rest, most);
    if (length >= rest) return last;
    const double even = from + p->of->direction * rest / ceil(rest / length);
    const double before = run->dense_steps[em_dense_at(run, even)].t, after = em_dense_beyond(run, even, 1.0);
    const double nearer = fabs(after - even) < fabs(even - before) ? after : before, other = nearer == before ? after : before;
    if (em_is_on_the_way(p, from, last, length, nearer)) return nearer;
    if (em_is_on_the_way(p, from, last, length, other)) return other;
    const double to = from + p->of->direction * (length > rest / 2.0 ? rest / 2.0 : length);
    const double least = run->dense_steps[em_dense_at(run, to)].t, part = p->of->direction * (least - from);
    const int costs_one = rest <= EM_FEW_STEPS * length && ceil((rest - part) / length) >= ceil(rest / length);
    return part > EM_LEAST_CUT * fabs(to - from) && !costs_one ? least : to;
}

/* The end of the next step, in a span that ends at `last`; within: whether the error within it counts. Where this
 * limits steps, and rows are not denser than these, a step ends at a row. */
static double em_next_end(const em_pass *p, double from, double last, int *within) {
    const em_variations *const w = p->of;
    const double most = fabs(em_dense_beyond(w->run, from, EM_MOST_LENGTH * w->initial_steps) - from);
    const double length = fmin(p->h, most), rest = fabs(last - from), longest = fmin(length, rest);
    const double with_rows = fmin(p->h_within, most);
    const size_t row = em_next_row(p, from, EM_AT_ROW * longest);
    const double next = em_distance_of_row(p, from, row), second = em_distance_of_row(p, from, row + 1);
    const int dense = second <= longest || next < EM_NO_STEP * longest || rest - next < EM_NO_STEP * longest;
    *within = next < rest && (dense || with_rows >= longest);
    if (*within) return em_end_towards(p, from, last, with_rows, most);
    return em_end_towards(p, from, next < rest ? w->t_rows[row] : last, length, most);
}

/* Whether there is a df/dp, of which a step resolves more than rounding. */
static int em_resolves_forcing(const em_pass *p, double from, double to) {
    const em_run *const run = p->of->run;
    return p->tape->basis > 0 && fabs(to - from) > EM_SHORTEST_FORCING * fabs(run->dense_steps[em_dense_at(run, from)].h);
}

/* The errors of the rest at the end of a step, and of whole directions within it, if that counts. */
static em_step_errors em_errors_with(em_pass *p, double h, int within, const double *K_rounding) {
    em_step_errors (*const error)(em_pass *, double, const double *) = p->wide ? em_error_wide : em_error_narrow;
    const double *const v = p->Z + (EM_VARIATION_NODES - 1) * 2 * p->n + p->n, *const a = p->a + (EM_VARIATION_NODES - 1) * p->n;
    em_step_errors found = error(p, h, K_rounding);
    if (!within || !em_has_shifts(p)) return found;
    em_add_shifted_step(p, 1.0), em_add_shifts(p, 1.0, v, a, p->S);
    found.within = fmax(found.end, error(p, h, K_rounding).within);
    em_add_shifted_step(p, -1.0), em_add_shifts(p, -1.0, v, a, p->S);
    return found;
}

/* The errors of a solved step; if those that count exceed one, without their rounding. */
static em_step_errors em_errors_of(em_pass *p, double from, double to, int within) {
    em_step_errors forced = {0.0, 0.0};
    if (p->tape) em_step_along_basis(p);
    if (p->tape && em_resolves_forcing(p, from, to)) forced = (p->wide ? em_forcing_error_wide : em_forcing_error_narrow)(p);
    const em_step_errors found = em_errors_with(p, to - from, within, NULL);
    p->by_rounding = (within ? found.within : found.end) > 1.0;
    if ((within ? found.within : found.end) <= 1.0 || em_rounding_of(p, to, p->K_rounding)) return em_larger_errors(found, forced);
    return em_larger_errors(em_errors_with(p, to - from, within, p->K_rounding), forced);
}

/* The next length of a step, after one of `length` whose error grows with this power of it. */
static double em_next_length(double before, double length, double error, int power) {
    const double growth = fmin(4.0, fmax(0.1, 0.8 * pow(fmax(error, 1e-30), -1.0 / power)));
    return error > 1.0 ? length * fmin(0.7, growth) : fmax(length < before ? before : 0.0, length * growth);
}

static void em_set_next_length(em_pass *p, double length, double least, em_step_errors errors) {
    p->h = fmax(em_next_length(p->h, length, errors.end, EM_END_POWER), least);
    p->h_within = fmax(em_next_length(p->h_within, length, errors.within, EM_WITHIN_POWER), least);
}

/* The roughness of the accelerations in a step, relative to that of a smooth motion; if it exceeds one, without its
 * rounding. */
static double em_roughness_of(em_pass *p, double to) {
    const double most = EM_JUMP_TOLERANCES * p->of->tolerance;
    memset(p->a_rounding, 0, p->n * sizeof *p->a_rounding);
    const double found = em_force_roughness(p) / most;
    return found <= 1.0 || em_rounding_of(p, to, p->K_rounding) ? found : em_force_roughness(p) / most;
}

/* One step starting at `from`, as long as possible, within a span that ends at `last`. Returns its end; NAN: it
 * failed. */
static double em_advance_variations(em_pass *p, double from, double last) {
    em_variations *const w = p->of;
    const double least = 128.0 * DBL_EPSILON * (fabs(from) + fabs(last));
    em_begin_step(p, from);
    for (;;) {
        int within;
        const double to = em_next_end(p, from, last, &within), length = fabs(to - from);
        const int solved = em_solve_step(p, from, to), is_least = length <= 2.0 * least;
        if (solved < 0) return NAN;
        const double rough = solved > 0 ? 0.0 : em_roughness_of(p, to);
        const em_step_errors none = {INFINITY, INFINITY}, of_step = solved > 0 ? none : em_errors_of(p, from, to, within);
        const em_step_errors errors = em_larger_errors(of_step, (em_step_errors){rough, rough});
        const double off = within ? errors.within : errors.end;
        p->n_least = is_least ? p->n_least + 1 : 0;
        p->n_crawling += length * EM_MOST_STEPS_OF_SPAN < fabs(last - from) ? 1 : p->n_crawling > 0 ? -1 : 0;
        if (is_least && rough > 1.0) return em_end_pass(w, EM_FORCE_JUMPS, -1, -1), w->t_reached = to, NAN;
        if (is_least && (solved > 0 || p->n_least > EM_MOST_LEAST)) return em_end_pass(w, EM_UNRESOLVED, -1, -1), w->t_reached = to, NAN;
        if (p->n_crawling > EM_MOST_CRAWLING) return em_end_pass(w, EM_UNRESOLVED, -1, -1), w->t_reached = to, NAN;
        if (off <= 1.0 || is_least) {
            p->longest = fmax(p->longest, length);
            if (length > 0.25 * p->longest && !p->by_rounding) p->n_again = 0;
            em_set_next_length(p, length, least, errors);
            return em_keep_step(p, from, to) ? NAN : to;
        }
        ++w->n_refused, ++p->n_again;
        em_set_next_length(p, length, least, errors);
        p->h = fmin(p->h, length); /* the part of the error that did not count does not lengthen what was refused */
    }
}

/* The lengths of steps at the start of a span: at least `initial`. With rows in it, a step stays as much shorter as it
 * was. */
static void em_begin_lengths(em_pass *p, double initial) {
    const double before = p->h;
    p->h = fmax(before, initial);
    p->h_within = before > 0.0 ? p->h_within * (p->h / before) : p->h;
}

/* Begins a span, which it enters at t. */
static int em_enter_span(em_pass *p, size_t span) {
    em_variations *const w = p->of;
    const double last = w->to[span], t = w->from[span];
    em_pass_pieces(p, t);
    if (p->tape && w->model->n_time_events) {
        em_begin_matrix(p);
        if (em_end_matrix(p, em_pass_time_events(p->over_basis, t, last, span == 0))) return -1;
    }
    if (em_pass_time_events(p, t, last, span == 0) || em_begin_span(p, t)) return -1;
    em_begin_lengths(p, fabs(em_dense_beyond(w->run, t, w->initial_steps) - t));
    return 0;
}

/* Computes the directions at `last`, from t in the same span. */
static int em_advance_to(em_pass *p, double t, double last) {
    while (t != last)
        if (isnan(t = em_advance_variations(p, t, last))) return -1;
    return 0;
}

#endif
