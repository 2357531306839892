/* em_rate_jacobian.h: exact derivatives of the right-hand side with respect to its own states, C and s included.
 *
 * NAME.c compiled with EM_ON_LANES and EM_ON_DUALS: its right-hand side on dual numbers, evaluated once for every
 * number of the state. It is compiled on demand (docs/architecture.md). */
#ifndef EM_RATE_JACOBIAN_H
#define EM_RATE_JACOBIAN_H

/* J (n_state, n_state) = d rhs / d y of the published system; NaN where that is singular. u (n_inputs) */
void em_rate_jacobian(double t, const double *y, const double *c, const double *u, double *J) {
    const double e = 0x1p-600; /* its square is zero */
    real at[N_STATE], dy[N_STATE], prepared[N_PREPARED + 1], inputs[N_INPUTS + 1];
    em_fault fault;
    for (int k = 0; k < N_STATE; ++k) at[k] = y[k];
    for (int k = 0; k < N_PREPARED; ++k) prepared[k] = c[k];
    for (int k = 0; k < N_INPUTS; ++k) inputs[k] = u[k];
    for (int k = 0; k < N_STATE; ++k) {
        __imag__ at[k] = e;
        model_rhs(0, t, at, prepared, inputs, NULL, 0, dy, &fault);
        __imag__ at[k] = 0.0;
        for (int row = 0; row < N_STATE; ++row)
            J[row * N_STATE + k] = em_value(dy[row]) == em_value(dy[row]) ? __imag__ dy[row] / e : NAN;
    }
}

#endif
