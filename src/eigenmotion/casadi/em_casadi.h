/* em_casadi.h: external functions of CasADi, with exact sparse Jacobians.
 *
 * Included behind the functions of NAME.c, after the tables of the export: own_parameters, chosen, EM_DEPENDENT_ROWS,
 * EM_REQUIRED, EM_EQUATION_PARTIALS and EM_OUTPUTS_ACCELERATE. Nothing is written but the results: threads may share
 * the functions.
 *
 * Derivatives have columns: the arguments of the model (x, v, inputs, parameters, time), followed by a (n) and the
 * multipliers (m), which inverse dynamics takes. */
#ifndef EM_CASADI_H
#define EM_CASADI_H

#ifndef casadi_real
#define casadi_real double
#endif
#ifndef casadi_int
#define casadi_int long long int
#endif
#ifndef CASADI_SYMBOL_EXPORT
#define CASADI_SYMBOL_EXPORT __attribute__((visibility("default")))
#endif

typedef enum em_in { EM_BY_X, EM_BY_V, EM_BY_Z, EM_BY_STATE, EM_BY_U, EM_BY_P, EM_BY_T, EM_BY_A, EM_BY_MULTIPLIERS } em_in;
typedef enum em_kind { EM_ACCELERATION, EM_RATES, EM_OUTPUTS, EM_INVERSE } em_kind;

enum { EM_COLUMNS = N_ARGUMENTS + N + N_ROWS };                                    /* of all derivatives */
enum { EM_MOTION_ROWS = N + N + N_ROWS };                                          /* v, a, multipliers */
enum { EM_MOST_ROWS_OF = (int)EM_MOTION_ROWS > (int)N_OUTPUTS ? EM_MOTION_ROWS : N_OUTPUTS };

/* A function: its kind and inputs; for each output, the first row of its derivatives, and the number of numbers; and
 * for each pair of an output and an input, the sparsity of that block. */
typedef struct em_signature {
    em_kind kind;
    int n_in, n_out;
    const em_in *in;
    const int *first_row;
    const casadi_int *const *blocks;
} em_signature;

/* The arguments of a call; a and lambda are zero where they are not given. */
typedef struct em_call {
    double t, x[N], v[N], a[N], lambda[EM_SOME_ROWS], u[N_INPUTS + 1], parameters[N_PARAMETERS + 1], c[N_PREPARED + 1];
} em_call;

/* The chosen columns of derivatives; by_state, by_forcing: whether there are such by x or v, or by other arguments. */
typedef struct em_chosen {
    int count, by_state, by_forcing, at[EM_COLUMNS];
} em_chosen;

EM_INLINE void em_read(int count, const casadi_real *from, double *to) {
    for (int k = 0; k < count && from != NULL; ++k) to[k] = from[k];
}

/* One input; NULL means zeros. */
EM_INLINE void em_read_input(em_in in, const casadi_real *from, em_call *at, double *parameters) {
    switch (in) {
    case EM_BY_X: em_read(N_COORDINATES, from, at->x); return;
    case EM_BY_V: em_read(N_COORDINATES, from, at->v); return;
    case EM_BY_Z: em_read(N - N_COORDINATES, from, at->v + N_COORDINATES); return;
    case EM_BY_STATE:
        em_read(N_COORDINATES, from, at->x);
        em_read(N, from == NULL ? NULL : from + N_COORDINATES, at->v);
        return;
    case EM_BY_U: em_read(N_INPUTS, from, at->u); return;
    case EM_BY_P:
        for (int k = 0; k < N_CHOSEN; ++k) parameters[chosen[k]] = from == NULL ? 0.0 : from[k];
        return;
    case EM_BY_T: em_read(1, from, &at->t); return;
    case EM_BY_A: em_read(N_COORDINATES, from, at->a); return;
    case EM_BY_MULTIPLIERS: em_read(N_ROWS, from, at->lambda); return;
    }
}

/* All inputs. 0, or -1: a parameter has a value that the model refuses. */
EM_INLINE int em_call_of(const em_signature *of, const casadi_real **arg, em_call *at) {
    em_fault fault;
    memset(at, 0, offsetof(em_call, parameters));
    memcpy(at->parameters, own_parameters, N_PARAMETERS * sizeof *own_parameters);
    for (int i = 0; i < of->n_in; ++i) em_read_input(of->in[i], arg[i], at, at->parameters);
#ifdef EM_ONE_PIECE
    if (N_CHOSEN == 0 && of->kind <= EM_RATES) return 0; /* nothing to prepare: parameters are numbers in the text */
#endif
    return prepare(at->parameters, at->c, &fault);
}

#ifdef EM_ONE_PIECE
/* The parameters: constants that compilers see, if none is an input. */
#define EM_PARAMETERS(at) (N_CHOSEN == 0 ? own_parameters : (at)->parameters)
#endif

/* --- values --- */

EM_INLINE void em_give(int count, const double *from, casadi_real *to) {
    for (int k = 0; k < count && to != NULL; ++k) to[k] = from[k];
}

/* a (n), lambda (m). Of rows that depend on each other, those have multipliers whose derivatives are given. 0, or -1. */
EM_INLINE int em_accelerations(const em_call *at, double *a, double *lambda) {
    em_fault fault;
    if (EM_DEPENDENT_ROWS) {
        em_factors factors;
        return em_motion_at(at->t, at->x, at->v, at->c, at->u, EM_DEPENDENT_ROWS, &factors, a, lambda, &fault);
    }
    return em_acceleration(at->t, at->x, at->v, at->c, at->u, 0, a, lambda, &fault);
}

/* tau (N_COORDINATES) = M a + A^T lambda - f, and the residual (N_ROWS) A a + gamma */
EM_INLINE void em_give_inverse(const em_call *at, casadi_real **res) {
    double r[N], s[EM_SOME_ROWS], A[EM_SOME_ROWS * N], b[EM_SOME_ROWS];
    EM_REQUIRED(at->t, at->x, at->v, at->a, at->c, at->u, r, s);
    if (N_ROWS > 0) {
        pfaffian(at->t, at->x, at->c, A, b);
        for (int row = 0; row < N_ROWS; ++row)
            for (int k = 0; k < N; ++k) r[k] += A[row * N + k] * at->lambda[row];
        em_give(N_ROWS, s, res[1]);
    }
    em_give(N_COORDINATES, r, res[0]);
}

/* Writes the results that are asked for. 0, or 1: there is no value. */
EM_INLINE int em_values(const em_signature *of, const casadi_real **arg, casadi_real **res) {
    em_call at;
    double a[N], lambda[EM_SOME_ROWS];
    if (em_call_of(of, arg, &at)) return 1;
    if (of->kind == EM_INVERSE) return em_give_inverse(&at, res), 0;
    if (of->kind == EM_OUTPUTS) {
        double out[N_OUTPUTS + 1];
        if (EM_OUTPUTS_ACCELERATE) {
            if (em_accelerations(&at, a, lambda)) return 1;
        } else {
            memset(a, 0, sizeof a);
            memset(lambda, 0, sizeof lambda);
        }
        observe(at.t, at.x, at.v, a, lambda, at.c, at.u, out);
        return em_give(N_OUTPUTS, out, res[0]), 0;
    }
#ifdef EM_ONE_PIECE
    double b[N + N_ROWS];
    if (motion_in_one_piece(at.t, at.x, at.v, EM_PARAMETERS(&at), at.u, b)) return 1;
    memcpy(a, b, sizeof a);
    memcpy(lambda, b + N, N_ROWS * sizeof *lambda);
#else
    if (em_accelerations(&at, a, lambda)) return 1;
#endif
    if (of->kind == EM_ACCELERATION) {
        em_give(N_COORDINATES, a, res[0]);
        if (N_ROWS > 0) em_give(N_ROWS, lambda, res[1]);
    } else if (res[0] != NULL) {
        em_give(N_COORDINATES, at.v, res[0]);
        em_give(N, a, res[0] + N_COORDINATES);
    }
    return 0;
}

/* --- derivatives --- */

/* Chooses `count` columns, from `first` on or by a list. */
EM_INLINE void em_choose_columns(em_chosen *to, int count, int first, const int *list) {
    for (int k = 0; k < count; ++k) {
        const int column = first + (list == NULL ? k : list[k]);
        to->at[to->count++] = column;
        if (column < 2 * N) to->by_state = 1;
        else if (column < N_ARGUMENTS) to->by_forcing = 1;
    }
}

EM_INLINE void em_choose(em_chosen *to, em_in in) {
    switch (in) {
    case EM_BY_X: em_choose_columns(to, N_COORDINATES, 0, NULL); return;
    case EM_BY_V: em_choose_columns(to, N_COORDINATES, N, NULL); return;
    case EM_BY_Z: em_choose_columns(to, N - N_COORDINATES, N + N_COORDINATES, NULL); return;
    case EM_BY_STATE:
        em_choose_columns(to, N_COORDINATES, 0, NULL);
        em_choose_columns(to, N, N, NULL);
        return;
    case EM_BY_U: em_choose_columns(to, N_INPUTS, 2 * N, NULL); return;
    case EM_BY_P: em_choose_columns(to, N_CHOSEN, 2 * N + N_INPUTS, chosen); return;
    case EM_BY_T: em_choose_columns(to, 1, N_ARGUMENTS - 1, NULL); return;
    case EM_BY_A: em_choose_columns(to, N_COORDINATES, N_ARGUMENTS, NULL); return;
    case EM_BY_MULTIPLIERS: em_choose_columns(to, N_ROWS, N_ARGUMENTS + N, NULL); return;
    }
}

/* W (n + m, count) <- the chosen columns of the derivatives of a and lambda, which are found, too. 0, or -1. */
static int em_motion_columns(const em_call *at, const em_chosen *of, double *a, double *lambda, double *W) {
    em_factors factors;
    em_fault fault;
    double by_state[(N + N_ROWS) * 2 * N], by_forcing[(N + N_ROWS) * N_FORCING];
    if (em_motion_at(at->t, at->x, at->v, at->c, at->u, EM_DEPENDENT_ROWS, &factors, a, lambda, &fault)) return -1;
    if (of->by_state) state_partials(at->t, at->x, at->v, a, lambda, at->c, at->u, by_state);
    if (of->by_forcing) forcing_partials(at->t, at->x, at->v, a, lambda, at->c, at->u, by_forcing);
    for (int row = 0; row < N + N_ROWS; ++row)
        for (int k = 0; k < of->count; ++k)
            W[row * of->count + k] = of->at[k] < 2 * N ? by_state[row * 2 * N + of->at[k]]
                                                       : by_forcing[row * N_FORCING + of->at[k] - 2 * N];
    em_solve_motion(&factors, of->count, W);
    return 0;
}

/* R (N_COORDINATES + n + m, count): of v, a and lambda. 0, or -1. */
EM_INLINE int em_rate_columns(const em_call *at, const em_chosen *of, double *R) {
    double a[N], lambda[EM_SOME_ROWS];
    for (int row = 0; row < N_COORDINATES; ++row)
        for (int k = 0; k < of->count; ++k) R[row * of->count + k] = of->at[k] == N + row ? 1.0 : 0.0;
    return em_motion_columns(at, of, a, lambda, R + N_COORDINATES * of->count);
}

#if EM_HAS_OUTPUTS
/* R (n_outputs, count): those at fixed a, lambda, and those by their changes. 0, or -1. */
static int em_output_columns(const em_call *at, const em_chosen *of, double *R) {
    enum { MOTION = N + N_ROWS, WIDTH = N + N_ROWS + N_ARGUMENTS };
    double a[N] = {0.0}, lambda[EM_SOME_ROWS] = {0.0}, W[MOTION * EM_COLUMNS], D[N_OUTPUTS * WIDTH];
    if (EM_OUTPUTS_ACCELERATE && em_motion_columns(at, of, a, lambda, W)) return -1;
    output_partials(at->t, at->x, at->v, a, lambda, at->c, at->u, D);
    for (int row = 0; row < N_OUTPUTS; ++row)
        for (int k = 0; k < of->count; ++k) R[row * of->count + k] = D[row * WIDTH + MOTION + of->at[k]];
    for (int row = 0; row < N_OUTPUTS && EM_OUTPUTS_ACCELERATE; ++row)
        for (int j = 0; j < MOTION; ++j)
            if (D[row * WIDTH + j] != 0.0) em_add_row(of->count, D[row * WIDTH + j], W + j * of->count, R + row * of->count);
    return 0;
}
#endif

/* An entry of the derivatives (n + m, EM_COLUMNS) of tau and the residual; D: by the arguments. */
EM_INLINE double em_inverse_entry(const double *D, const double *M, const double *A, int row, int column) {
    if (column < N_ARGUMENTS) return D[row * N_ARGUMENTS + column];
    if (column < N_ARGUMENTS + N) return row < N ? M[row * N + column - N_ARGUMENTS] : A[(row - N) * N + column - N_ARGUMENTS];
    return row < N ? A[(column - N_ARGUMENTS - N) * N + row] : 0.0;
}

/* R (n + m, count) */
static void em_inverse_columns(const em_call *at, const em_chosen *of, double *R) {
    double D[(N + N_ROWS) * N_ARGUMENTS], M[N * N], A[EM_SOME_ROWS * N], b[EM_SOME_ROWS];
    EM_EQUATION_PARTIALS(at->t, at->x, at->v, at->a, at->lambda, at->c, at->u, D);
    mass_matrix(at->t, at->x, at->c, M);
    if (N_ROWS > 0) pfaffian(at->t, at->x, at->c, A, b);
    for (int row = 0; row < N + N_ROWS; ++row)
        for (int k = 0; k < of->count; ++k) R[row * of->count + k] = em_inverse_entry(D, M, A, row, of->at[k]);
}

static int em_columns(const em_signature *of, const em_call *at, const em_chosen *chosen_columns, double *R) {
    switch (of->kind) {
    case EM_ACCELERATION:
    case EM_RATES: return em_rate_columns(at, chosen_columns, R);
    case EM_INVERSE: return em_inverse_columns(at, chosen_columns, R), 0;
    case EM_OUTPUTS: break;
    }
#if EM_HAS_OUTPUTS
    return em_output_columns(at, chosen_columns, R);
#else
    return -1;
#endif
}

/* The entries of a block that are not structurally zero, column by column; R has `width` columns. */
EM_INLINE void em_give_block(const casadi_int *sparsity, int width, const double *R, casadi_real *to) {
    const casadi_int *const begin = sparsity + 2, *const row = begin + sparsity[1] + 1;
    for (casadi_int column = 0; column < sparsity[1]; ++column)
        for (casadi_int k = begin[column]; k < begin[column + 1]; ++k) to[k] = R[row[k] * width + column];
}

#ifdef EM_ONE_PIECE
/* The same of accelerations and rates; W0, W1 without the first rows, which belong to v. */
EM_INLINE void em_give_piece(const casadi_int *sparsity, const em_chosen *of, int first_row, const double *W0,
                             const double *W1, casadi_real *to) {
    const casadi_int *const begin = sparsity + 2, *const rows = begin + sparsity[1] + 1;
    for (casadi_int column = 0; column < sparsity[1]; ++column) {
        const int place = place_of_argument[of->at[column]], width = place < N_WIDTH_0 ? N_WIDTH_0 : N_WIDTH_1;
        const double *const W = place < N_WIDTH_0 ? W0 + place : W1 + place - N_WIDTH_0;
        for (casadi_int k = begin[column]; k < begin[column + 1]; ++k) {
            const int row = (int)rows[k] + first_row - N_COORDINATES;
            to[k] = row < 0 ? 1.0 : place < 0 ? 0.0 : W[row * width];
        }
    }
}

EM_INLINE int em_jacobians_of_piece(const em_signature *of, const em_call *at, casadi_real **res) {
    double W0[(N + N_ROWS) * N_WIDTH_0 + 1], W1[(N + N_ROWS) * N_WIDTH_1 + 1];
    int others = 0;
    for (int k = 0; k < of->n_in * of->n_out; ++k)
        others |= res[k] != NULL && (of->in[k % of->n_in] == EM_BY_P || of->in[k % of->n_in] == EM_BY_T);
    if (slopes_in_one_piece(at->t, at->x, at->v, EM_PARAMETERS(at), at->u, others, W0, W1)) return 1;
    for (int k = 0; k < of->n_in * of->n_out; ++k) {
        if (res[k] == NULL) continue;
        em_chosen columns = {0};
        em_choose(&columns, of->in[k % of->n_in]);
        em_give_piece(of->blocks[k], &columns, of->first_row[k / of->n_in], W0, W1, res[k]);
    }
    return 0;
}
#endif

/* Writes the blocks that are asked for, and computes only their columns. 0, or 1: there are none. */
EM_INLINE int em_jacobians(const em_signature *of, const casadi_real **arg, casadi_real **res) {
    em_call at;
    em_chosen columns = {0};
    int first[EM_BY_MULTIPLIERS + 1];
    double R[EM_MOST_ROWS_OF * EM_COLUMNS];
    if (em_call_of(of, arg, &at)) return 1;
#ifdef EM_ONE_PIECE
    if (of->kind <= EM_RATES) return em_jacobians_of_piece(of, &at, res);
#endif
    for (int i = 0; i < of->n_in; ++i) {
        int asked = 0;
        for (int o = 0; o < of->n_out; ++o) asked |= res[o * of->n_in + i] != NULL;
        first[i] = columns.count;
        if (asked) em_choose(&columns, of->in[i]);
    }
    if (columns.count == 0) return 0;
    if (em_columns(of, &at, &columns, R)) return 1;
    for (int k = 0; k < of->n_in * of->n_out; ++k)
        if (res[k] != NULL)
            em_give_block(of->blocks[k], columns.count, R + of->first_row[k / of->n_in] * columns.count + first[k % of->n_in], res[k]);
    return 0;
}

#endif
