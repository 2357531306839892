/* em_branch.h: positions of the dependent coordinates of a mechanism, on one branch, as the others move.
 *
 * phi(x, t) = 0 for the dependent coordinates x_D (d), while t and the others move along a straight line. Each step is
 * predicted along the tangent and closed by Newton's method, whose corrections must shrink to a quarter. It is halved
 * where the determinant of independent rows of A_D falls below half, so that no step passes a zero of it, where branches
 * meet: steps towards a dead centre become ever shorter, until that is what is said. Its rows are the h of positions; the
 * others, if there are any, are those of frictions.
 * The same in Python: analysis/driving/path_following.py. */
#ifndef EM_BRANCH_H
#define EM_BRANCH_H

#include "eigenmotion.h"
#include "numeric/em_complete_pivoting.h"

#define EM_BRANCH_SINGULAR 1e-7  /* least pivot of A_D, with unit rows of A in the mass metric, at full rank */
#define EM_BRANCH_CONTRACTS 0.25 /* largest ratio of two corrections if the branch is the predicted one */
#define EM_BRANCH_ROUNDED 1e-9   /* corrections below this part of x may be rounding */
#define EM_BRANCH_KEPT 0.5       /* least part of the determinant that is left after a step */
#define EM_BRANCH_SHORTEST 1e-8  /* shortest step, as a part of the line */
#define EM_BRANCH_CLOSED 1e4     /* largest residual phi, in roundings of its terms */

enum { EM_BRANCH_CORRECTIONS = 12, EM_GUESS_CORRECTIONS = 50 };

typedef struct em_branch {
    const em_model *model;
    const double *c;
    int d;
    const int *dependent; /* (d) indices of coordinates */
    const double *unit;   /* (n) 1 / sqrt(M_kk): changes of coordinates in these units can be compared */
} em_branch;

/* A_D (h, d) at a position, with unit rows of A; the lengths (h) that these had; A (m, n), b (m) of A v + b; its d most
 * independent rows. */
typedef struct em_branch_rows {
    double *G, *length, *b, *A;
    int *row;
} em_branch_rows;

/* row (d) <- the rows of G (m, d) that add most to those before. */
static void em_branch_choose(int m, int d, const double *G, int *row) {
    double left[m * d];
    memcpy(left, G, sizeof left);
    for (int k = 0; k < d; ++k) {
        double most = -1.0, unit[d];
        for (int i = 0; i < m; ++i) {
            const double square = em_inner(d, left + i * d, left + i * d);
            if (square > most) most = square, row[k] = i;
        }
        for (int j = 0; j < d; ++j) unit[j] = most > 0.0 ? left[row[k] * d + j] / sqrt(most) : 0.0;
        for (int i = 0; i < m; ++i) {
            const double along = em_inner(d, unit, left + i * d);
            for (int j = 0; j < d; ++j) left[i * d + j] -= along * unit[j];
        }
        for (int j = 0; j < d; ++j) left[row[k] * d + j] = 0.0;
    }
}

static void em_branch_rows_at(const em_branch *of, double t, const double *x, em_branch_rows *at) {
    const int n = of->model->n, m = of->model->h, d = of->d;
    of->model->pfaffian(t, x, of->c, at->A, at->b);
    for (int i = 0; i < m; ++i) {
        double square = 0.0;
        for (int k = 0; k < n; ++k) square += at->A[i * n + k] * of->unit[k] * at->A[i * n + k] * of->unit[k];
        at->length[i] = square > 0.0 ? sqrt(square) : 1.0;
        for (int j = 0; j < d; ++j)
            at->G[i * d + j] = at->A[i * n + of->dependent[j]] * of->unit[of->dependent[j]] / at->length[i];
    }
    for (int k = 0; k < d; ++k) at->row[k] = k;
    if (m > d) em_branch_choose(m, d, at->G, at->row);
}

/* y (d) of these rows <- G_rows^-1 right (m); the determinant, and *least: the least pivot. Both 0: it is singular. */
static double em_branch_solved(const em_branch *of, const double *G, const int *row, const double *right, double *y,
                               double *least) {
    const int d = of->d;
    double S[d * d], determinant = 1.0;
    int sign = 1;
    for (int i = 0; i < d; ++i) {
        y[i] = right[row[i]];
        for (int j = 0; j < d; ++j) S[i * d + j] = G[row[i] * d + j];
    }
    *least = INFINITY;
    if (em_solve_completely(d, S, y, 0.0, &sign)) return *least = 0.0;
    for (int k = 0; k < d; ++k) determinant *= fabs(S[k * d + k]), *least = fmin(*least, fabs(S[k * d + k]));
    return sign * determinant;
}

/* w_D <- with A w = - right (h), by the rows; w (n) is changed there alone. The least pivot. */
static double em_branch_dependent(const em_branch *of, const em_branch_rows *at, const double *right, double *w) {
    const int m = of->model->h, d = of->d;
    double scaled[m], y[d], least;
    for (int i = 0; i < m; ++i) scaled[i] = -right[i] / at->length[i];
    em_branch_solved(of, at->G, at->row, scaled, y, &least);
    for (int j = 0; j < d; ++j) w[of->dependent[j]] = y[j] * of->unit[of->dependent[j]];
    return least;
}

/* The length of x or of a change of it, of all coordinates or, with d, of the dependent ones. */
static double em_branch_length(const em_branch *of, const double *x, int dependent) {
    double square = 0.0;
    const int count = dependent ? of->d : of->model->n - of->model->n_states;
    for (int j = 0; j < count; ++j) {
        const int k = dependent ? of->dependent[j] : j;
        square += x[k] / of->unit[k] * (x[k] / of->unit[k]);
    }
    return sqrt(square);
}

/* The row whose residual is the largest in roundings, with its residual; -1: all are rounding. */
static int em_branch_open_row(const em_branch *of, double t, const double *x, const em_branch_rows *at, double *residual) {
    const int m = of->model->h;
    const double size = em_branch_length(of, x, 0);
    double phi[m], terms[m], worst = EM_BRANCH_CLOSED;
    int row = -1;
    of->model->position(t, x, of->c, phi, terms);
    for (int i = 0; i < m; ++i) {
        const double rounding = DBL_EPSILON * (terms[i] + DBL_EPSILON * at->length[i] * size);
        const double part = fabs(phi[i]) / fmax(rounding, DBL_MIN);
        if (!(part <= worst)) worst = part, row = i, *residual = phi[i];
    }
    return row;
}

/* x <- closed near by. Each correction is at most `ratio` of the one before. 0, or -1: it is not reached. */
static int em_branch_close(const em_branch *of, double t, double *x, double ratio, int most, em_branch_rows *at) {
    double last = INFINITY, residual, phi[of->model->h], terms[of->model->h];
    double step[of->model->n], before[of->model->n];
    for (int pass = 0; pass < most; ++pass) {
        em_branch_rows_at(of, t, x, at);
        of->model->position(t, x, of->c, phi, terms);
        if (!(em_branch_dependent(of, at, phi, step) > 0.0)) return -1;
        memcpy(before, x, sizeof before);
        for (int j = 0; j < of->d; ++j) x[of->dependent[j]] += step[of->dependent[j]];
        const double size = em_branch_length(of, step, 1), whole = em_branch_length(of, x, 0);
        if (size <= 4.0 * DBL_EPSILON * whole) break;
        if (!(size <= ratio * last)) { /* it stalls by rounding, or it is lost: back, and see */
            for (int j = 0; j < of->d && !(size <= EM_BRANCH_ROUNDED * whole); ++j)
                x[of->dependent[j]] = before[of->dependent[j]];
            break;
        }
        last = size;
    }
    em_branch_rows_at(of, t, x, at);
    return em_branch_open_row(of, t, x, at, &residual) < 0 ? 0 : -1;
}

/* Whether a determinant of independent rows keeps its sign and half its size. */
static int em_branch_keeps(const em_branch *of, const em_branch_rows *before, const em_branch_rows *after) {
    const int *const rows[2] = {before->row, after->row};
    double none[of->model->h], y[of->d], least;
    memset(none, 0, sizeof none);
    for (int k = 0; k < 2; ++k) {
        const double was = em_branch_solved(of, before->G, rows[k], none, y, &least);
        const double now = em_branch_solved(of, after->G, rows[k], none, y, &least);
        if (now * was > 0.0 && fabs(now) >= EM_BRANCH_KEPT * fabs(was)) return 1;
    }
    return 0;
}

/* The straight line of time and of the independent coordinates, from their start to their end. */
typedef struct em_line {
    double t[2];
    const double *x[2];
} em_line;

static double em_on_line(double from, double to, double s) { return s == 1.0 ? to : from + s * (to - from); }

/* next (n) <- x (n), at `at` and the part s of the line, moved to the part `end`; `there` <- its rows. 0, or -1. */
static int em_branch_step(const em_branch *of, const em_line *line, double s, double end, const double *x,
                          const em_branch_rows *at, double *next, em_branch_rows *there) {
    const int n = of->model->n, m = of->model->h;
    const double dt = (end - s) * (line->t[1] - line->t[0]);
    double d[n], right[m];
    for (int k = 0; k < n; ++k) next[k] = em_on_line(line->x[0][k], line->x[1][k], end);
    for (int j = 0; j < of->d; ++j) next[of->dependent[j]] = x[of->dependent[j]];
    for (int k = 0; k < n; ++k) d[k] = next[k] - x[k];
    for (int i = 0; i < m; ++i) {
        right[i] = at->b[i] * dt;
        for (int k = 0; k < n; ++k) right[i] += at->A[i * n + k] * d[k];
    }
    if (!(em_branch_dependent(of, at, right, d) > 0.0)) return -1;
    for (int j = 0; j < of->d; ++j) next[of->dependent[j]] += d[of->dependent[j]];
    if (em_branch_close(of, em_on_line(line->t[0], line->t[1], end), next, EM_BRANCH_CONTRACTS, EM_BRANCH_CORRECTIONS, there))
        return -1;
    return em_branch_keeps(of, at, there) ? 0 : -1;
}

/* x (n), closed at the start of a line <- at its end, on the same branch. 1; or the part of the line that is reached,
 * where x stands. */
static double em_branch_follow(const em_branch *of, const em_line *line, double *x) {
    const int n = of->model->n, m = of->model->m, d = of->d;
    double memory[2][m * (n + d + 2)], next[n], s = 0.0, step = 1.0;
    int chosen[2][d], here = 0;
    em_branch_rows at[2];
    for (int k = 0; k < 2; ++k)
        at[k] = (em_branch_rows){memory[k], memory[k] + m * d, memory[k] + m * (d + 1), memory[k] + m * (d + 2), chosen[k]};
    em_branch_rows_at(of, line->t[0], x, &at[0]);
    while (s < 1.0) {
        const double end = fmin(1.0, s + step);
        if (em_branch_step(of, line, s, end, x, &at[here], next, &at[1 - here])) step = 0.5 * (end - s);
        else step = 2.0 * (end - s), s = end, here = 1 - here, memcpy(x, next, sizeof next);
        if (step < EM_BRANCH_SHORTEST) break;
    }
    return s;
}

/* The least pivot of A_D at a position, and loose (d) <- how much each dependent coordinate moves while the others rest,
 * if it is nearly zero. */
static double em_branch_independence(const em_branch *of, double t, const double *x, em_branch_rows *at, double *loose) {
    const int d = of->d;
    double S[d * d], y[d], none[of->model->h], least;
    memset(none, 0, sizeof none);
    em_branch_rows_at(of, t, x, at);
    em_branch_solved(of, at->G, at->row, none, y, &least);
    for (int i = 0; i < d; ++i) /* a little beside, so that it can be solved: the direction is that of the null space */
        for (int j = 0; j < d; ++j) S[i * d + j] = at->G[at->row[i] * d + j] + (i == j ? EM_BRANCH_ROUNDED : 0.0);
    for (int i = 0; i < d; ++i) loose[i] = 1.0 + 0.3 * i;
    if (em_solve_completely(d, S, loose, 0.0, NULL)) memset(loose, 0, d * sizeof *loose);
    return least;
}

#endif
