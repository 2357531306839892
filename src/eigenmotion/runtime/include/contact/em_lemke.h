/* em_lemke.h: Lemke's complementary pivoting, for active sets of many contacts and frictions.
 *
 * Lemke (1965), with a lexicographic ratio test, which prevents cycling. The mixed problem of em_complementarity.h is
 * transformed to s = b + A z, s >= 0, z >= 0, s z = 0: free rows are eliminated, and each friction is split in two,
 *
 *     z = (p of contacts, L + p of frictions, -w of frictions where that is negative)
 *     s = (w of contacts, w of frictions where that is positive, L - p of frictions)                 (Glocker and Pfeiffer)
 *
 * It ends at a solution, or on a ray. With large friction, a ray does not mean that there is no solution: modes are
 * then tried one after the other. */
#ifndef EM_LEMKE_H
#define EM_LEMKE_H

enum { EM_PIVOTED = 2 * EM_MIXED_ROWS, EM_TABLEAU = 2 * EM_PIVOTED + 2 };

/* The tableau of `size` basic variables: row (s, z, cover, right side); basis: which variable is basic in each. */
typedef struct em_lemke {
    int size, basis[EM_PIVOTED];
    double row[EM_PIVOTED][EM_TABLEAU];
} em_lemke;

EM_NOINLINE void em_lemke_pivot(em_lemke *l, int leaves, int enters) {
    const int width = 2 * l->size + 2;
    const double pivot = l->row[leaves][enters];
    for (int j = 0; j < width; ++j) l->row[leaves][j] /= pivot;
    for (int i = 0; i < l->size; ++i) {
        const double part = l->row[i][enters];
        if (i == leaves || part == 0.0) continue;
        for (int j = 0; j < width; ++j) l->row[i][j] -= part * l->row[leaves][j];
    }
    l->basis[leaves] = enters;
}

/* Whether row i precedes row j in the ratio test: by the right side over the column, then lexicographically by the
 * columns of the identity. */
EM_NOINLINE int em_lemke_before(const em_lemke *l, int i, int j, int enters) {
    const int right = 2 * l->size + 1;
    const double a = l->row[i][enters], b = l->row[j][enters];
    double apart = l->row[i][right] / a - l->row[j][right] / b;
    for (int column = 0; column < l->size && apart == 0.0; ++column) apart = l->row[i][column] / a - l->row[j][column] / b;
    return apart < 0.0;
}

/* The row of the variable that leaves when `enters` enters; -1: a ray. The covering variable leaves whenever it may. */
EM_NOINLINE int em_lemke_leaving(const em_lemke *l, int enters) {
    int best = -1;
    for (int i = 0; i < l->size; ++i) {
        if (!(l->row[i][enters] > EM_MODE_RANK)) continue;
        if (best < 0 || em_lemke_before(l, i, best, enters)) best = i;
    }
    for (int i = 0; best >= 0 && i < l->size; ++i)
        if (l->basis[i] == 2 * l->size && l->row[i][enters] > EM_MODE_RANK && !em_lemke_before(l, best, i, enters)) return i;
    return best;
}

/* Solves s = b + A z. Returns whether it succeeded; the basis holds the solution. */
EM_NOINLINE int em_lemke_solve(em_lemke *l, const double *A, const double *b) {
    const int n = l->size, cover = 2 * n, right = cover + 1;
    int lowest = 0;
    for (int i = 0; i < n; ++i) {
        for (int j = 0; j < n; ++j) l->row[i][j] = i == j, l->row[i][n + j] = -A[i * n + j];
        l->row[i][cover] = -1.0, l->row[i][right] = b[i];
        l->basis[i] = i;
        if (b[i] < b[lowest]) lowest = i;
    }
    if (n == 0 || b[lowest] >= 0.0) return 1;
    int leaves = lowest, enters = cover;
    for (int steps = 0; steps < 50 * (n + 1); ++steps) {
        const int left = l->basis[leaves];
        em_lemke_pivot(l, leaves, enters);
        if (left == cover) return 1;
        enters = left < n ? left + n : left - n;
        leaves = em_lemke_leaving(l, enters);
        if (leaves < 0) return 0;
    }
    return 0;
}

/* Eliminates the free rows: G, q <- G - G_f F^-1 G_f^T ... over the rows that are not free. 0, or -1. */
EM_NOINLINE int em_without_free(const em_mixed *s, double *G, double *q) {
    const int k = s->k;
    int free_row[EM_MIXED_ROWS], count = 0;
    memcpy(G, s->G, k * k * sizeof *G);
    memcpy(q, s->q, k * sizeof *q);
    for (int i = 0; i < k; ++i)
        if (s->kind[i] == EM_ROW_FREE) free_row[count++] = i;
    for (int n = 0; n < count; ++n) {
        const int f = free_row[n];
        const double pivot = G[f * k + f];
        if (!(pivot > EM_MODE_RANK)) return -1;
        for (int i = 0; i < k; ++i) {
            const double part = G[i * k + f] / pivot;
            if (i == f || part == 0.0) continue;
            for (int j = 0; j < k; ++j) G[i * k + j] -= part * G[f * k + j];
            q[i] -= part * q[f];
        }
    }
    return 0;
}

/* s->choice <- by pivoting. Returns whether that succeeded. Barred choices are excluded: such contacts stay open,
 * and frictions that are released slide in the direction chosen for them. */
EM_NOINLINE int em_pivot_modes(em_mixed *s, int bars) {
    const int k = s->k;
    int contact[EM_MIXED_ROWS], friction[EM_MIXED_ROWS], nc = 0, nf = 0;
    double G[EM_MIXED_ROWS * EM_MIXED_ROWS], q[EM_MIXED_ROWS];
    double A[EM_PIVOTED * EM_PIVOTED] = {0.0}, b[EM_PIVOTED] = {0.0};
    double fixed[EM_MIXED_ROWS]; /* the sign of p / L where it is known */
    for (int i = 0; i < k; ++i)
        if (s->kind[i] == EM_ROW_CONE) return 0; /* the problem is not linear */
    if (em_without_free(s, G, q)) return 0;
    for (int i = 0; i < k; ++i) {
        const int barred = bars && s->barred[i] == EM_HOLDS_ROW;
        fixed[i] = 0.0;
        if (s->kind[i] == EM_ROW_SLIDES) fixed[i] = -s->side[i];
        else if (s->kind[i] == EM_ROW_FRICTION && barred) fixed[i] = s->choice[i] == EM_BACK ? 1.0 : -1.0;
        else if (s->kind[i] == EM_ROW_FRICTION) friction[nf++] = i;
        else if (s->kind[i] == EM_ROW_CONTACT && !barred) contact[nc++] = i;
    }
    const int n = nc + 2 * nf;
    em_lemke l = {.size = n};
    for (int r = 0; r < nc + nf; ++r) {
        const int row = r < nc ? contact[r] : friction[r - nc];
        b[r] = q[row];
        for (int c = 0; c < nc; ++c) A[r * n + c] = G[row * k + contact[c]];
        for (int f = 0; f < nf; ++f) A[r * n + nc + f] = G[row * k + friction[f]];
        for (int f = 0; f < k; ++f) { /* -L of frictions that may stick, the limit of sliding ones */
            const double sign = fixed[f] != 0.0 ? fixed[f] : s->kind[f] == EM_ROW_FRICTION ? -1.0 : 0.0;
            if (sign == 0.0) continue;
            b[r] += sign * s->level[f] * G[row * k + f];
            for (int c = 0; c < nc; ++c)
                A[r * n + c] += sign * s->coefficient[f] * s->over[f * k + contact[c]] * G[row * k + f];
        }
    }
    for (int f = 0; f < nf; ++f) {
        const int slack = nc + nf + f;
        A[(nc + f) * n + slack] = 1.0;
        A[slack * n + nc + f] = -1.0;
        b[slack] = 2.0 * s->level[friction[f]];
        for (int c = 0; c < nc; ++c)
            A[slack * n + c] = 2.0 * s->coefficient[friction[f]] * s->over[friction[f] * k + contact[c]];
    }
    if (!em_lemke_solve(&l, A, b)) return 0;
    int basic[2 * EM_PIVOTED + 1] = {0};
    for (int i = 0; i < n; ++i) basic[l.basis[i]] = 1;
    for (int i = 0; i < k; ++i)
        if (s->kind[i] == EM_ROW_CONTACT) s->choice[i] = EM_OPENS;
    for (int c = 0; c < nc; ++c)
        if (basic[n + c]) s->choice[contact[c]] = EM_HOLDS_ROW;
    for (int f = 0; f < nf; ++f) /* L + p is not basic: it is zero, and the row slides forward; likewise L - p */
        s->choice[friction[f]] = !basic[n + nc + f] ? EM_FORWARD : !basic[nc + nf + f] ? EM_BACK : EM_HOLDS_ROW;
    return 1;
}

#endif
