/* em_row_forces.h: multipliers with friction that is proportional to them, so that reactions act along other rows than
 * those of the constraints. */
#ifndef EM_ROW_FORCES_H
#define EM_ROW_FORCES_H

/* Q = P L^-T and B Q^T of a root */
EM_NOINLINE void em_push(double t, const double *x, const double *v, const double *c, const double *u, em_root *root) {
    double *const Q = root->Q;
    pushes(t, x, v, c, u, Q);
    for (int row = 0; row < EM_PUSHED; ++row) em_forward(N, root->L, root->r, Q + row * N);
    for (int i = 0; i < N_ROWS; ++i)
        for (int j = 0; j < EM_PUSHED; ++j) {
            root->pushed[i * EM_PUSHED + j] = 0.0;
            for (int k = 0; k < N; ++k) root->pushed[i * EM_PUSHED + j] += root->B[i * N + k] * Q[j * N + k];
        }
}

#ifdef EM_NORMALS
/* lambda (m) <- (B Q^T)^-1 lambda if norms of multipliers act, too; Q <- at the direction of the resulting multipliers.
 * 0, or -1 and *fault. */
EM_NOINLINE int em_solve_norm_push(em_root *root, double *lambda, int flags, em_fault *fault) {
    double all[EM_PUSHED], gradient[N_NORMALS * N_ROWS];
    memcpy(all, lambda, N_ROWS * sizeof *lambda);
    if (em_solve_normed(N_ROWS, N_NORMALS, normals[0], root->pushed, all, gradient, flags, fault)) return -1;
    memcpy(lambda, all, N_ROWS * sizeof *lambda);
    for (int f = 0; f < N_NORMALS; ++f)
        for (int row = 0; row < N_ROWS; ++row) {
            const double part = gradient[f * N_ROWS + row];
            for (int k = 0; k < N; ++k) root->Q[row * N + k] += part * root->Q[(N_ROWS + f) * N + k];
            for (int i = 0; i < N_ROWS; ++i)
                root->pushed[i * EM_PUSHED + row] += root->pushed[i * EM_PUSHED + N_ROWS + f] * part;
        }
    return 0;
}
#endif

/* lambda (m) <- (B Q^T)^-1 lambda. 0, or -1 and *fault. */
EM_NOINLINE int em_solve_push(const em_root *root, double *lambda, int least_norm, em_fault *fault) {
    const int flags = em_flags_at(root, least_norm);
    double pushed[N_ROWS * N_ROWS];
    for (int i = 0; i < N_ROWS * N_ROWS; ++i) pushed[i] = root->pushed[i / N_ROWS * EM_PUSHED + i % N_ROWS];
#ifdef EM_NORMALS
    double unit[N_ROWS];
    if (!em_is_square_of_rows(N_ROWS, pushed)) {
        em_units_of_rows(N_ROWS, root->Delta, unit);
        if (em_solve_norm_friction(N_ROWS, pushed, unit, lambda, flags)) return 0;
        return em_fail(fault, EM_CONTACTS_CLASH, -1, EM_JAMMED, NAN);
    }
#endif
    return em_solve_pushed(N_ROWS, pushed, lambda, flags, fault);
}

#endif
