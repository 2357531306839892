/* em_active_set.h: the active set (mode): which contacts are closed, which frictions stick or slide, and the
 * conditions that end it.
 *
 * A mode is the set of constraint rows that hold. It is encoded in the prepared parameters: a switched row has a
 * parameter as a factor, 1 or 0, and a row that is 0 has no multiplier (em_fill_inactive_rows). A contact holds until
 * it would pull, a friction sticks until its force would exceed its limit. Both conditions are functions of the
 * multiplier, which is then their event function.
 *
 * A contact that touches, or a friction at its limit without slip, is idle if other rows keep it so: its row depends
 * on theirs, and needs no force. The parameter that marks it as idle is its tolerance, beyond which it counts as
 * moving. */
#ifndef EM_ACTIVE_SET_H
#define EM_ACTIVE_SET_H

#include "dynamics/em_mechanics.h"

enum { EM_IMPACT_ROWS = N_ROWS + 1, EM_IMPACT_SIZE = N + 2 /* the data of an impact: N (n), rate, e */ };

/* N v + rate */
EM_NOINLINE double em_approach(const double *impact_data, const double *v) {
    double speed = impact_data[N];
    for (int k = 0; k < N; ++k) speed += impact_data[k] * v[k];
    return speed;
}

/* The largest speed of approach along N at this kinetic energy, sqrt(N M^-1 N^T v^T M v), plus that of phi itself. */
EM_NOINLINE double em_fastest(const em_root *root, const double *impact_data, const double *v) {
    double along[N], p[N];
    memcpy(along, impact_data, sizeof along);
    memcpy(p, v, sizeof p);
    em_forward(N, root->L, root->r, along);
    em_transposed(N, root->L, p);
    return em_length(N, along) * em_length(N, p) + fabs(impact_data[N]);
}

#include "contact/em_complementarity.h"

enum { EM_SOME_SWITCHES = N_SWITCHES > 0 ? N_SWITCHES : 1, EM_LEVELS = 2 /* limit of sliding, limit of sticking */ };

EM_NOINLINE int em_is_contact(const em_switch *s) { return s->slides < 0; }

EM_NOINLINE int em_holds(const em_switch *s, const double *c) { return c[s->holds] != 0.0; }

EM_NOINLINE int em_is_idle(const em_switch *s, const double *c) { return c[s->idles] > 0.0; }

#ifdef EM_CONES
EM_NOINLINE int em_is_cone(const em_switch *s) { return s->shift >= 0; }
#else /* compilers see that, and remove the code for cones */
EM_INLINE int em_is_cone(const em_switch *s) { return (void)s, 0; }
#endif

/* The magnitude along a friction's row, or along the two rows of a cone. */
EM_NOINLINE double em_along_switch(const em_switch *s, const double *of_rows) {
    return em_is_cone(s) ? hypot(of_rows[s->row], of_rows[s->row + 1]) : fabs(of_rows[s->row]);
}

/* The largest force at which a friction sticks. */
EM_NOINLINE double em_limit(const em_switch *s, double level, const double *lambda) {
    if (em_norm_of(s) >= 0) return level * em_norm_of_multipliers(em_norm_of(s), lambda);
    return s->over < 0 ? level : level * fmax(0.0, -lambda[switches[s->over].row]);
}

/* The state of a switch in a mode: whether its row holds, the sign of its slip, and its tolerance if it idles; for a
 * cone, the shift added to its slips, without which its force has no direction at zero slip. */
typedef struct em_state_of_switch {
    int holds, slides;
    double idles, shift[2];
} em_state_of_switch;

/* c <- the constants of this mode (n_switches). 0, or -1 and *fault. */
EM_NOINLINE int em_set_mode(double *c, const em_state_of_switch *mode, em_fault *fault) {
    double parameters[N_PARAMETERS + 1];
    int same = 1;
    memcpy(parameters, c, N_PARAMETERS * sizeof *parameters);
    for (int k = 0; k < N_SWITCHES; ++k) {
        const em_switch *const s = &switches[k];
        same &= c[s->holds] == mode[k].holds && c[s->idles] == mode[k].idles;
        parameters[s->holds] = mode[k].holds, parameters[s->idles] = mode[k].idles;
        if (s->slides < 0) continue; /* a contact */
        same &= c[s->slides] == mode[k].slides;
        parameters[s->slides] = mode[k].slides;
        for (int i = 0; i < 2 * em_is_cone(s); ++i) {
            same &= c[s->shift + i] == mode[k].shift[i];
            parameters[s->shift + i] = mode[k].shift[i];
        }
    }
    return same ? 0 : prepare(parameters, c, fault);
}

EM_NOINLINE void em_mode_of(const double *c, em_state_of_switch *mode) {
    for (int k = 0; k < N_SWITCHES; ++k) {
        const em_switch *const s = &switches[k];
        mode[k] = (em_state_of_switch){em_holds(s, c), em_is_contact(s) ? 0 : (int)c[s->slides], c[s->idles], {0.0, 0.0}};
        if (em_is_cone(s)) memcpy(mode[k].shift, c + s->shift, sizeof mode[k].shift);
    }
}

#if EM_HOLDS(EM_ASIDE)
/* Whether a friction idles without force. */
EM_NOINLINE int em_idles_unloaded(const em_switch *s, const double *c) {
    return !em_is_contact(s) && !em_is_cone(s) && em_is_idle(s, c) && c[s->slides] == 0.0;
}

/* g (n_events) <- the slips of frictions that idle without force: their own functions have a factor that is zero. 0,
 * or -1 and *fault. */
EM_NOINLINE int em_watch_unloaded(double t, const double *x, const double *v, const double *c, const double *u, double *g,
                                  em_fault *fault) {
    em_state_of_switch mode[EM_SOME_SWITCHES];
    double as_if[N_PREPARED + 1], own[N_EVENTS];
    int some = 0;
    em_mode_of(c, mode);
    for (int k = 0; k < N_SWITCHES; ++k)
        if (em_idles_unloaded(&switches[k], c)) mode[k].slides = 1, some = 1;
    if (!some) return 0;
    memcpy(as_if, c, N_PREPARED * sizeof *c);
    if (em_set_mode(as_if, mode, fault)) return -1;
    model_events(t, x, v, as_if, u, own);
    for (int k = 0; k < N_SWITCHES; ++k)
        if (em_idles_unloaded(&switches[k], c)) g[switches[k].event] = own[switches[k].event];
    return 0;
}

/* g (n_events) <- with the conditions of the mode: the margin of a multiplier before release, of an idle row before
 * it moves. 0, or -1 and *fault. */
EM_EXPORT int em_watch_modes(double t, const double *x, const double *v, const double *c, const double *u,
                             int least_norm, double *g, em_fault *fault) {
    double a[N], lambda[EM_SOME_ROWS], level[EM_LEVELS * EM_SOME_SWITCHES];
    int some = 0;
    if (em_watch_unloaded(t, x, v, c, u, g, fault)) return -1;
    for (int k = 0; k < N_SWITCHES; ++k) {
        double *const own = g + switches[k].event;
        some |= em_holds(&switches[k], c);
        *own = c[switches[k].idles] + (em_is_idle(&switches[k], c) && !em_is_cone(&switches[k]) ? -fabs(*own) : *own);
    }
    if (!some) return 0;
    if (em_acceleration(t, x, v, c, u, least_norm, a, lambda, fault)) return -1;
    levels(t, x, v, c, u, level);
    for (int k = 0; k < N_SWITCHES; ++k) {
        const em_switch *const s = &switches[k];
        if (!em_holds(s, c)) continue;
        const double limit = em_is_contact(s) ? 0.0 : em_limit(s, level[EM_LEVELS * k + 1], lambda);
        g[s->event] = em_is_contact(s) ? -lambda[s->row] : limit - em_along_switch(s, lambda);
    }
    return 0;
}

/* em_model.acceleration: the same as em_acceleration, but the multipliers of idle frictions are their forces, as if
 * their rows held, so that results contain them in every mode. */
EM_EXPORT int em_acceleration_with_idle(double t, const double *x, const double *v, const double *c, const double *u,
                                    int least_norm, double *a, double *lambda, em_fault *fault) {
    double level[EM_LEVELS * EM_SOME_SWITCHES];
    if (em_acceleration(t, x, v, c, u, least_norm, a, lambda, fault)) return -1;
    levels(t, x, v, c, u, level);
    for (int k = 0; k < N_SWITCHES; ++k) {
        const em_switch *const s = &switches[k];
        if (!em_is_contact(s) && !em_is_cone(s) && em_is_idle(s, c)) lambda[s->row] = c[s->slides] * em_limit(s, level[EM_LEVELS * k], lambda);
    }
    return 0;
}
#endif

/* --- the rows of contacts and frictions, in any mode --- */

/* At a state: A, b, the root of M and B = A L^-T of all rows that may hold (in `c` all of them do), gaps and rates
 * along rows, and the sums of the magnitudes of their terms. */
typedef struct em_all_rows {
    double c[N_PREPARED + 1], A[EM_SOME_ROWS * N], b[EM_SOME_ROWS];
    double gap[EM_SOME_ROWS], gap_terms[EM_SOME_ROWS], rate[EM_SOME_ROWS], rate_terms[EM_SOME_ROWS];
    em_root root;
    int permanent[EM_SOME_ROWS]; /* whether a row holds in every mode and is independent of the others that do */
} em_all_rows;

/* Rates A v + b. */
EM_NOINLINE void em_rates_along(em_all_rows *r, const double *v) {
    for (int row = 0; row < N_ROWS; ++row) {
        r->rate[row] = r->b[row], r->rate_terms[row] = fabs(r->b[row]);
        for (int k = 0; k < N; ++k) {
            r->rate[row] += r->A[row * N + k] * v[k];
            r->rate_terms[row] += fabs(r->A[row * N + k] * v[k]);
        }
    }
}

/* Delta (m, m) <- of the rows that hold in every mode, except `without`; switched (m) <- the others. Returns
 * whether there are any of the former. */
EM_NOINLINE int em_unswitched(const em_all_rows *r, int without, double *Delta, int *switched) {
    int any = 0;
    memcpy(Delta, r->root.Delta, sizeof r->root.Delta);
    for (int k = 0; k < N_ROWS; ++k) switched[k] = 0;
    for (int k = 0; k < N_SWITCHES; ++k) switched[switches[k].row] = switched[switches[k].row + em_is_cone(&switches[k])] = 1;
    for (int i = 0; i < N_ROWS; ++i) {
        any |= !switched[i];
        for (int j = 0; j <= i; ++j)
            if (switched[i] || switched[j] || i == without || j == without) Delta[i * N_ROWS + j] = 0.0;
    }
    return any;
}

/* A row whose multiplier is the normal force of a friction but is not unique, because it depends on others that hold
 * in every mode; -1: none. */
EM_NOINLINE int em_shared_normal(const em_all_rows *r) {
    double Delta[EM_SOME_ROWS * EM_SOME_ROWS];
    int switched[EM_SOME_ROWS];
    if (!em_unswitched(r, -1, Delta, switched)) return -1;
    const int rank = em_rank(EM_SOME_ROWS, Delta);
    for (int k = 0; k < N_SWITCHES; ++k)
        for (int row = 0; row < N_ROWS && em_norm_of(&switches[k]) >= 0; ++row) {
            if (switched[row] || !em_is_in_norm(em_norm_of(&switches[k]), row)) continue;
            em_unswitched(r, row, Delta, switched);
            if (em_rank(EM_SOME_ROWS, Delta) == rank) return row;
        }
    return -1;
}

/* permanent <- the rows that hold in every mode and are independent. */
EM_NOINLINE void em_find_permanent(em_all_rows *r) {
    double Delta[EM_SOME_ROWS * EM_SOME_ROWS];
    int switched[EM_SOME_ROWS], kept;
    const int any = em_unswitched(r, -1, Delta, switched);
    const int rank = any ? em_independent_rows(EM_SOME_ROWS, Delta, EM_DEPENDENT, &kept) : 0;
    for (int i = 0; i < N_ROWS; ++i)
        r->permanent[i] = !switched[i] && (rank == 0 || (int)N_ROWS > (int)EM_MOST_ROWS || (kept & EM_FIRST_KEPT << i));
}

EM_NOINLINE int em_all_rows_at(double t, const double *x, const double *v, const double *c, em_all_rows *r, em_fault *fault) {
    em_state_of_switch all[EM_SOME_SWITCHES];
    memcpy(r->c, c, N_PREPARED * sizeof *c);
    for (int k = 0; k < N_SWITCHES; ++k) all[k] = (em_state_of_switch){.holds = 1};
    if (em_set_mode(r->c, all, fault) || em_root_at(t, x, r->c, &r->root, fault)) return -1;
    pfaffian(t, x, r->c, r->A, r->b);
    position(t, x, r->c, r->gap, r->gap_terms);
    for (int row = 0; row < N_POSITIONS; ++row) /* plus the rounding of x itself */
        for (int k = 0; k < N; ++k) r->gap_terms[row] += fabs(r->A[row * N + k] * x[k]);
    em_rates_along(r, v);
    em_find_permanent(r);
    return 0;
}

/* Initialises the problem with only the rows that hold in every mode. G is for all rows. */
EM_NOINLINE void em_begin_mixed(const em_all_rows *r, em_mixed *s) {
    *s = (em_mixed){.k = EM_IMPACT_ROWS};
    for (int i = 0; i < EM_IMPACT_ROWS; ++i) {
        s->barred[i] = EM_NO_CHOICE;
        s->kind[i] = i < N_ROWS && r->permanent[i] ? EM_ROW_FREE : EM_ROW_OUT;
        for (int j = 0; j < EM_IMPACT_ROWS && i < N_ROWS; ++j) {
            double sum = 0.0;
            for (int k = 0; k < N && j < N_ROWS; ++k) sum += r->root.B[i * N + k] * r->root.B[j * N + k];
            s->G[i * EM_IMPACT_ROWS + j] = sum;
        }
    }
}

/* side <- the sign of the slip of a sliding friction, or the direction of the slip of a cone. rate (m); c: the mode. */
EM_NOINLINE void em_side_of_slip(const em_switch *friction, const double *rate, const double *c, double *side) {
    double slip[2] = {rate[friction->row], em_is_cone(friction) ? rate[friction->row + 1] : 0.0};
    for (int i = 0; em_is_cone(friction) && i < 2; ++i) slip[i] += c[friction->shift + i];
    const double size = hypot(slip[0], slip[1]);
    for (int i = 0; i <= em_is_cone(friction); ++i) side[i] = slip[i] / size;
}

/* A friction's row, or the two rows of a cone, with their limits. rate (m): of those that slide, in the mode of c;
 * NULL: at rest. */
EM_NOINLINE void em_friction_row(em_mixed *s, int k, const double *level, const double *rate, const double *c) {
    const em_switch *const friction = &switches[k];
    const int norm = em_norm_of(friction), presses = friction->over >= 0 || norm >= 0, cone = em_is_cone(friction);
    for (int row = friction->row; row <= friction->row + cone; ++row) {
        const int first = row == friction->row;
        s->kind[row] = rate ? EM_ROW_SLIDES : !cone ? EM_ROW_FRICTION : first ? EM_ROW_CONE : EM_ROW_CONE_SECOND;
        s->side[row] = 0.0;
        s->choice[row] = EM_HOLDS_ROW;
        if (friction->over >= 0) s->over[row * EM_IMPACT_ROWS + switches[friction->over].row] = 1.0;
        s->rooted[row] = norm >= 0;
        for (int j = 0; j < N_ROWS && norm >= 0; ++j) s->over[row * EM_IMPACT_ROWS + j] = em_is_in_norm(norm, j);
        (presses ? s->coefficient : s->level)[row] = level[EM_LEVELS * k];
        (presses ? s->coefficient_at_rest : s->at_rest)[row] = fmax(level[EM_LEVELS * k], level[EM_LEVELS * k + 1]);
    }
    if (rate) em_side_of_slip(friction, rate, c, s->side + friction->row);
}

#if defined(EM_CONES) && EM_HOLDS(EM_ASIDE)
/* lambda (m) <- with the largest reserve, if rows that hold are dependent (em_force_sharing.h). Delta: of the mode. */
EM_EXPORT void em_share_multipliers(double t, const double *x, const double *v, const double *c, const double *u,
                                    const double *Delta, double *lambda) {
    em_mixed s = {.k = EM_IMPACT_ROWS};
    double level[EM_LEVELS * EM_SOME_SWITCHES], rate[EM_SOME_ROWS];
    levels(t, x, v, c, u, level);
    for (int row = 0; row < N_ROWS; ++row) s.kind[row] = EM_ROW_FREE, rate[row] = 1.0, s.p[row] = -lambda[row];
    for (int k = 0; k < N_SWITCHES; ++k) {
        const em_switch *const one = &switches[k];
        for (int row = one->row; row <= one->row + em_is_cone(one); ++row) s.kind[row] = EM_ROW_OUT;
        if (em_holds(one, c) && em_is_contact(one)) s.kind[one->row] = EM_ROW_CONTACT, s.choice[one->row] = EM_HOLDS_ROW;
        else if (!em_is_contact(one) && (em_holds(one, c) || c[one->slides] != 0.0))
            em_friction_row(&s, k, level, em_holds(one, c) ? NULL : rate, c);
    }
    for (int i = 0; i < N_ROWS; ++i)
        for (int j = 0; j <= i; ++j) s.G[i * s.k + j] = s.G[j * s.k + i] = Delta[i * N_ROWS + j];
    em_scale_mixed(&s, 0);
    const int shared = em_share(&s) == 0;
    em_scale_mixed(&s, 1);
    for (int row = 0; shared && row < N_ROWS; ++row)
        if (em_row_holds(&s, row)) lambda[row] = -s.p[row];
}
#endif

#endif
