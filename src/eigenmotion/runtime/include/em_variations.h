/* em_variations.h: how a motion changes with what it starts from and what it is given.
 *
 *     d/dt dx = dv,   d/dt dv = a_x dx + a_v dv + a_p dp
 *
 * along the rows of a run, of any em_model, x and v with them, by steps of dop853 that end at every row. After a step the
 * directions are put back to where the constraints stay satisfied. One more direction is a witness: (v, a) itself obeys
 * these equations as long as no force jumps. Where one does, an event must say where: then directions jump with it. */
#ifndef EM_VARIATIONS_H
#define EM_VARIATIONS_H

#include "em_variation_events.h"

static void em_keep_directions(const em_pass *p, size_t row) {
    const int n = p->n, k = p->columns;
    for (int i = 0; i < 2 * n; ++i)
        memcpy(p->of->S + (row * 2 * n + i) * (k - 1), p->y + 2 * n + i * k, (k - 1) * sizeof *p->y);
}

/* All of y <- as far on as `ahead` says, by its rates: beyond an event, or to it. */
static int em_move_beside(em_pass *p, double t, double ahead) {
    if (em_variation_rate(p, t, p->y, p->K[0])) return -1;
    for (int i = 0; i < p->size; ++i) p->y[i] += ahead * p->K[0][i];
    return 0;
}

/* From one row to the next, `beside` each that is at an event. */
static int em_variation_between(em_pass *p, size_t row, int leaves, int meets, double beside, double *h) {
    em_variations *const w = p->of;
    double start = w->t[row - 1], end = w->t[row];
    memcpy(p->y, w->z + (row - 1) * 2 * p->n, 2 * p->n * sizeof *p->y);
    if (start == end) return 0;
    if (leaves) {
        if (em_move_beside(p, start, beside)) return -1;
        start += beside;
    }
    if (meets) end -= beside;
    if (*h == 0.0) *h = end - start;
    if (em_variation_leg(p, start, end, h)) return -1;
    return meets ? em_move_beside(p, end, beside) : 0;
}

static int em_variation_rows(em_pass *p) {
    em_variations *const w = p->of;
    size_t mark = 0;
    double h = w->n_rows > 1 ? w->t[1] - w->t[0] : 0.0, length = h;
    int leaves = 0, acted = 0;
    for (size_t row = 0; row < w->n_rows; ++row) {
        const int meets = mark < w->n_marks && w->mark_row[mark] == (long)row;
        if (row > 0 && !acted) {
            length = w->t[row] - w->t[row - 1];
            if (em_variation_between(p, row, leaves, meets, EM_BESIDE * length, &h)) return -1;
        }
        memcpy(p->y, w->z + row * 2 * p->n, 2 * p->n * sizeof *p->y);
        leaves = meets || acted;
        em_keep_directions(p, row);
        acted = meets ? em_variation_marks(p, row, &mark, EM_BESIDE * length) : 0;
        if (acted < 0) return -1;
        if (meets && !acted && row + 1 < w->n_rows) em_keep_directions(p, row);
    }
    return 0;
}

/* The memory of a pass, and where its parts are. 0, or -1. */
static int em_pass_open(em_pass *p, em_variations *w) {
    const int n = w->model->n, m = w->model->m, k = w->columns + 1, size = 2 * n * (k + 1), n_inputs = w->model->n_inputs;
    const int n_c = w->model->n_prepared + 1, n_events = w->model->n_events;
    const size_t numbers = (size_t)size * (2 + EM_STAGES) + (size_t)(w->n_given + n + m) * k + n_inputs + n + m + n_c;
    double *next = calloc(numbers + 1, sizeof *next);
    *p = (em_pass){.of = w, .n = n, .m = m, .columns = k, .size = size, .renew = 1, .y = next};
    p->piece = calloc(n_inputs + 1, sizeof *p->piece);
    p->pile = calloc(n_events + 1, sizeof *p->pile);
    if (!next || !p->piece || !p->pile) return em_fail(&w->fault, EM_OUT_OF_MEMORY, -1, -1, 0.0);
    p->direction = w->t[w->n_rows - 1] < w->t[0] ? -1.0 : 1.0;
    next += size;
    p->next = next, next += size;
    for (int i = 0; i < EM_STAGES; ++i) p->K[i] = next, next += size;
    p->P = next, next += w->n_given * k;
    p->W = next, next += (n + m) * k;
    p->u = next, next += n_inputs;
    p->a = next, next += n;
    p->lambda = next, next += m;
    p->c = next;
    return 0;
}

static void em_pass_close(em_pass *p) {
    free(p->y);
    free(p->piece);
    free(p->pile);
}

/* S <- all rows. 0, or -1 and w->fault, w->why; rows from where it failed on are untouched. */
static int em_vary(em_variations *w) {
    em_pass pass;
    w->fault = (em_fault){EM_FINISHED, -1, -1, 0.0};
    w->why = EM_BY_FAULT;
    int status = em_pass_open(&pass, w);
    if (status == 0) {
        const int n = pass.n, k = pass.columns;
        for (int i = 0; i < w->model->n_inputs; ++i)
            pass.piece[i] = em_signal_piece(&w->inputs[i], w->t[0], pass.direction);
        memcpy(pass.c, w->c, w->model->n_prepared * sizeof *w->c);
        for (int i = 0; i < w->n_given; ++i) memcpy(pass.P + i * k, w->P + i * (k - 1), (k - 1) * sizeof *w->P);
        pass.P[(w->n_given - 1) * k + k - 1] = 1.0; /* the witness goes with the time */
        for (int i = 0; i < 2 * n; ++i) memcpy(pass.y + 2 * n + i * k, w->S + i * (k - 1), (k - 1) * sizeof *w->S);
        status = em_variation_rows(&pass);
    }
    em_pass_close(&pass);
    return status;
}

#endif
