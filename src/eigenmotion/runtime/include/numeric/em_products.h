/* em_products.h: products of small dense matrices, row-major. From four rows on, products of doubles are formed in
 * vectors, since a compiler that unrolls small loops leaves single numbers. Smaller ones, and those on lanes, are
 * left to the compiler. */
#ifndef EM_PRODUCTS_H
#define EM_PRODUCTS_H

#include "numeric/em_real.h"

/* Before a loop along a row: do not unroll it, so that it is vectorised. */
#if defined(__clang__)
#define EM_ALONG _Pragma("clang loop vectorize(enable)")
#else
#define EM_ALONG _Pragma("GCC unroll 1")
#endif

/* v (n) <- C^T w */
EM_INLINE void em_transposed_product(int n, const real *restrict C, const real *restrict w, real *restrict v) {
    EM_ALONG
    for (int j = 0; j < n; ++j) {
        real sum = C[j] * w[0];
        for (int i = 1; i < n; ++i) sum += C[i * n + j] * w[i];
        v[j] = sum;
    }
}

/* r (rows) <- D x + sign r */
EM_INLINE void em_product_plus(int rows, int n, const real *restrict D, const real *restrict x, double sign,
                               real *restrict r) {
    for (int i = 0; i < rows; ++i) {
        real sum = sign * r[i];
        for (int k = 0; k < n; ++k) sum += D[i * n + k] * x[k];
        r[i] = sum;
    }
}

enum { EM_TILE = 4 }; /* rows of a product that are formed together, with independent sums */

/* The number of rows of a product that are formed in tiles. */
#ifndef EM_PACKED
EM_INLINE int em_tiled(EM_UNUSED int n) { return 0; }
#else
EM_INLINE int em_tiled(int n) { return __builtin_constant_p(n) ? n / EM_TILE * EM_TILE : 0; }

/* Columns first ... first + width of a tile of rows of A B, in registers. The next row of B is loaded while one is
 * used; loaded at its use, GCC may load it for each row of A. Two tiles side by side, if there are enough columns,
 * share the loads of A, and the sums of one hide the latency of the other. */
#define EM_TILES_OF(width)                                                                                             \
    typedef double em_numbers_##width __attribute__((vector_size(8 * width)));                                         \
    typedef double em_stored_##width __attribute__((vector_size(8 * width), aligned(8), may_alias));                   \
    EM_INLINE void em_tile_##width(int n, int first, double sign, const double *restrict A,                            \
                                   const double *restrict B, double *restrict O) {                                     \
        em_numbers_##width sum[EM_TILE] = {{0.0}}, b = *(const em_stored_##width *)(B + first);                        \
        for (int k = 0;; ++k) {                                                                                        \
            for (int row = 0; row < EM_TILE; ++row) sum[row] += A[row * n + k] * b;                                    \
            if (k + 1 == n) break;                                                                                     \
            b = *(const em_stored_##width *)(B + (k + 1) * n + first);                                                 \
        }                                                                                                              \
        for (int row = 0; row < EM_TILE; ++row) *(em_stored_##width *)(O + row * n + first) = sign * sum[row];         \
    }                                                                                                                  \
    EM_INLINE void em_tiles_##width(int n, int first, double sign, const double *restrict A,                           \
                                    const double *restrict B, double *restrict O) {                                    \
        em_numbers_##width left[EM_TILE] = {{0.0}}, right[EM_TILE] = {{0.0}};                                          \
        em_numbers_##width b = *(const em_stored_##width *)(B + first);                                                \
        em_numbers_##width c = *(const em_stored_##width *)(B + first + width);                                        \
        for (int k = 0;; ++k) {                                                                                        \
            for (int row = 0; row < EM_TILE; ++row) {                                                                  \
                left[row] += A[row * n + k] * b;                                                                       \
                right[row] += A[row * n + k] * c;                                                                      \
            }                                                                                                          \
            if (k + 1 == n) break;                                                                                     \
            b = *(const em_stored_##width *)(B + (k + 1) * n + first);                                                 \
            c = *(const em_stored_##width *)(B + (k + 1) * n + first + width);                                         \
        }                                                                                                              \
        for (int row = 0; row < EM_TILE; ++row) {                                                                      \
            *(em_stored_##width *)(O + row * n + first) = sign * left[row];                                            \
            *(em_stored_##width *)(O + row * n + first + width) = sign * right[row];                                   \
        }                                                                                                              \
    }                                                                                                                  \
    EM_INLINE void em_forward_##width(int n, int rows, int first, const double *restrict L, const double *restrict r,  \
                                      double *restrict X) {                                                            \
        em_numbers_##width x[n];                                                                                       \
        for (int i = 0; i < rows; ++i) x[i] = *(const em_stored_##width *)(X + i * n + first);                         \
        EM_UNROLL for (int k = 0; k < rows; ++k) {                                                                     \
            x[k] *= r[k];                                                                                              \
            EM_UNROLL for (int i = k + 1; i < rows; ++i) x[i] -= L[i * n + k] * x[k];                                  \
            *(em_stored_##width *)(X + k * n + first) = x[k];                                                          \
        }                                                                                                              \
    }
EM_TILES_OF(8)
EM_TILES_OF(4)
EM_TILES_OF(2)
EM_TILES_OF(1)
#undef EM_TILES_OF

typedef double em_numbers __attribute__((vector_size(8 * EM_LANES), may_alias));

#if EM_LANES >= 4
#define EM_BY_TILES
typedef em_numbers_4 em_tile[EM_TILE]; /* rows */
typedef long long em_marks_4 __attribute__((vector_size(32))); /* of a comparison: -1 or 0 */

/* Marks the columns of a row of a diagonal tile that are left of the diagonal. */
static const em_marks_4 em_before[EM_TILE] = {{0, 0, 0, 0}, {-1, 0, 0, 0}, {-1, -1, 0, 0}, {-1, -1, -1, 0}};

/* x where marked, else 0 */
EM_INLINE em_numbers_4 em_marked(em_marks_4 marks, em_numbers_4 x) { return (em_numbers_4)(marks & (em_marks_4)x); }

EM_INLINE void em_load_tile(int n, const double *restrict A, em_numbers_4 *restrict X) {
    for (int row = 0; row < EM_TILE; ++row) X[row] = *(const em_stored_4 *)(A + row * n);
}

EM_INLINE void em_store_tile(int n, const em_numbers_4 *restrict X, double *restrict A) {
    for (int row = 0; row < EM_TILE; ++row) *(em_stored_4 *)(A + row * n) = X[row];
}

/* T <- sign X^T */
EM_INLINE void em_transpose_tile(double sign, const em_numbers_4 *restrict X, em_numbers_4 *restrict T) {
    for (int row = 0; row < EM_TILE; ++row) T[row] = sign * (em_numbers_4){X[0][row], X[1][row], X[2][row], X[3][row]};
}
#endif
#endif

/* T <- A^T */
EM_INLINE void em_transpose(int n, const real *restrict A, real *restrict T) {
    int tiled = 0;
#ifdef EM_BY_TILES
    tiled = em_tiled(n);
    for (int i = 0; i < tiled; i += EM_TILE)
        for (int j = 0; j < tiled; j += EM_TILE) {
            em_tile X, turned;
            em_load_tile(n, A + i * n + j, X);
            em_transpose_tile(1.0, X, turned);
            em_store_tile(n, turned, T + j * n + i);
        }
#endif
    for (int i = 0; i < n; ++i)
        for (int j = i < tiled ? tiled : 0; j < n; ++j) T[j * n + i] = A[i * n + j];
}

/* The upper triangle of A <- the lower. */
EM_INLINE void em_mirror(int n, real *A) {
    int tiled = 0;
#ifdef EM_BY_TILES
    tiled = em_tiled(n);
    for (int i = 0; i < tiled; i += EM_TILE) {
        for (int j = 0; j < i; j += EM_TILE) {
            em_tile X, turned;
            em_load_tile(n, A + i * n + j, X);
            em_transpose_tile(1.0, X, turned);
            em_store_tile(n, turned, A + j * n + i);
        }
        for (int row = i; row < i + EM_TILE; ++row)
            for (int j = i; j < row; ++j) A[j * n + row] = A[row * n + j];
    }
#endif
    for (int i = tiled; i < n; ++i)
        for (int j = 0; j < i; ++j) A[j * n + i] = A[i * n + j];
}

/* X (n, n) <- L^-1 X, L lower, r = 1 / diag L; with `upper`, entries below the diagonal are not all computed. Column
 * loops end at constants of their own: for a loop that begins where another ended, GCC assumes a first column n. */
EM_INLINE void em_forward_columns(int n, int upper, const real *restrict L, const real *restrict r, real *restrict X) {
    int j = 0;
#ifdef EM_PACKED
    if (em_tiled(n) && n > EM_TILE) {
        const int eights = EM_LANES >= 8 ? n / 8 * 8 : 0, fours = EM_LANES >= 4 ? n / 4 * 4 : 0;
        for (; j < eights; j += 8) em_forward_8(n, upper ? j + 8 : n, j, L, r, X);
        for (j = eights; j < fours; j += 4) em_forward_4(n, upper ? j + 4 : n, j, L, r, X);
        for (j = fours; j < n / 2 * 2; j += 2) em_forward_2(n, upper ? j + 2 : n, j, L, r, X);
    }
#endif
    for (int i = 0; i < n; ++i)
        for (int k = upper && i > j ? i : j; k < n; ++k) {
            real sum = X[i * n + k];
            for (int l = 0; l < i; ++l) sum -= L[i * n + l] * X[l * n + k];
            X[i * n + k] = sum * r[i];
        }
}

#if defined(EM_ON_LANES) && !defined(EM_ON_DUALS)
enum { EM_TALL = 4, EM_WIDE = EM_LANES >= 8 ? 4 : 2 }; /* the tile of a product on lanes that fits into registers */

/* EM_TALL rows and EM_WIDE columns of sign A B: B_kj is at k down + j across. */
EM_INLINE void em_lane_tile(int n, double sign, const real *restrict A, const real *restrict B, int down, int across,
                            real *restrict O) {
    real sum[EM_TALL][EM_WIDE];
    EM_UNROLL for (int i = 0; i < EM_TALL; ++i)
        EM_UNROLL for (int j = 0; j < EM_WIDE; ++j) sum[i][j] = A[i * n] * B[j * across];
    EM_ALONG for (int k = 1; k < n; ++k)
        EM_UNROLL for (int i = 0; i < EM_TALL; ++i)
            EM_UNROLL for (int j = 0; j < EM_WIDE; ++j) sum[i][j] += A[i * n + k] * B[k * down + j * across];
    EM_UNROLL for (int i = 0; i < EM_TALL; ++i)
        EM_UNROLL for (int j = 0; j < EM_WIDE; ++j) O[i * n + j] = sign * sum[i][j];
}

/* O (n, n) <- sign A B in such tiles; the remainder, at the end of rows and below the last whole tiles, is not
 * computed. With `lower`, nor are entries above the diagonal. */
EM_INLINE void em_lane_tiles(int n, int lower, double sign, const real *restrict A, const real *restrict B, int down,
                             int across, real *restrict O) {
    for (int i = 0; i + EM_TALL <= n; i += EM_TALL)
        for (int j = 0; j + EM_WIDE <= n && (!lower || j < i + EM_TALL); j += EM_WIDE)
            em_lane_tile(n, sign, A + i * n, B + j * across, down, across, O + i * n + j);
}

/* The number of columns of row i that are in tiles. */
EM_INLINE int em_lane_tiled(int n, int i) { return i < n / EM_TALL * EM_TALL ? n / EM_WIDE * EM_WIDE : 0; }
#else
EM_INLINE void em_lane_tiles(EM_UNUSED int n, EM_UNUSED int lower, EM_UNUSED double sign, EM_UNUSED const real *A,
                             EM_UNUSED const real *B, EM_UNUSED int down, EM_UNUSED int across, EM_UNUSED real *O) {}
EM_INLINE int em_lane_tiled(EM_UNUSED int n, EM_UNUSED int i) { return 0; }
#endif

/* O (n, n) <- sign A B; with `lower`, entries above the diagonal are not all computed. */
EM_INLINE void em_multiply(int n, int lower, double sign, const real *restrict A, const real *restrict B,
                           real *restrict O) {
#ifdef EM_PACKED
    for (int row = 0; row < em_tiled(n); row += EM_TILE) {
        const real *const rows = A + row * n;
        real *const product = O + row * n;
        const int last = lower ? row + EM_TILE : n;
        int j = 0;
        for (; EM_LANES >= 8 && j + 16 <= last; j += 16) em_tiles_8(n, j, sign, rows, B, product);
        for (; EM_LANES == 4 && j + 8 <= last; j += 8) em_tiles_4(n, j, sign, rows, B, product);
        for (; EM_LANES >= 8 && j + 8 <= n && j < last; j += 8) em_tile_8(n, j, sign, rows, B, product);
        for (; EM_LANES >= 4 && j + 4 <= n && j < last; j += 4) em_tile_4(n, j, sign, rows, B, product);
        for (; j + 2 <= n && j < last; j += 2) em_tile_2(n, j, sign, rows, B, product);
        if (n % 2 && j < last) em_tile_1(n, j, sign, rows, B, product); /* n % 2: GCC assumes a column n of an even n */
    }
#endif
    em_lane_tiles(n, lower, sign, A, B, n, 1, O);
    for (int i = em_tiled(n); i < n; ++i)
        for (int j = em_lane_tiled(n, i); j < (lower ? i + 1 : n); ++j) {
            real sum = sign * A[i * n] * B[j];
            for (int k = 1; k < n; ++k) sum += sign * A[i * n + k] * B[k * n + j];
            O[i * n + j] = sum;
        }
}

#endif
