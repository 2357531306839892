/* em_node_vectors.h: arrays over the nodes of a step, in vectors of the machine's width: vector b holds the EM_LANES
 * nodes from b EM_LANES on. */
#ifndef EM_NODE_VECTORS_H
#define EM_NODE_VECTORS_H

#include "tableaux/em_radau_nodes.h"
#include "stepper/em_model_calls.h"

EM_INLINE em_node_vector em_node_vector_at(const double *numbers) { return *(const em_node_vector *)numbers; }

/* Number j of eight. */
EM_INLINE double em_number_at(em_node_vector *const *at, int k, int j) {
    return ((const double *)&at[j / EM_LANES][k])[j % EM_LANES];
}

EM_INLINE void em_put_at(em_node_vector *const *at, int k, int j, double number) {
    ((double *)&at[j / EM_LANES][k])[j % EM_LANES] = number;
}

/* Unrolled by hand: a loop would store the vector to memory and wait for it. */
EM_INLINE double em_sum_of(em_node_vector a) {
#if EM_LANES == 8
    return ((a[0] + a[4]) + (a[1] + a[5])) + ((a[2] + a[6]) + (a[3] + a[7]));
#elif EM_LANES == 4
    return (a[0] + a[2]) + (a[1] + a[3]);
#elif EM_LANES == 2
    return a[0] + a[1];
#else
    return a;
#endif
}

/* The integral over the step, as a part of its duration, of row k; and the integral of its integrals from the start. */
EM_INLINE double em_integral_to_end(em_node_vector *const *at, int k) {
    em_node_vector sum = {0.0};
    for (int b = 0; b < EM_NODE_VECTORS; ++b) sum += em_node_vector_at(em_end_weight + b * EM_LANES) * at[b][k];
    return em_sum_of(sum);
}

EM_INLINE double em_second_integral_to_end(em_node_vector *const *at, int k) {
    em_node_vector sum = {0.0};
    for (int b = 0; b < EM_NODE_VECTORS; ++b) {
        const em_node_vector left = 1.0 - em_node_vector_at(em_node_place + b * EM_LANES);
        sum += left * em_node_vector_at(em_end_weight + b * EM_LANES) * at[b][k];
    }
    return em_sum_of(sum);
}

enum { EM_SUMS = 4 }; /* independent partial sums */

/* The tables of a collocation step, as locals: the compiler then knows that a store to one does not change the
 * addresses of the others. */
typedef struct em_tables {
    em_node_vector *F[EM_NODE_VECTORS], *a[EM_NODE_VECTORS], *series[EM_NODE_VECTORS];
    const double *weight;
} em_tables;

EM_INLINE em_tables em_tables_of(const em_run_state *w) {
    em_tables at = {.weight = w->nodes.weight};
    EM_UNROLL
    for (int b = 0; b < EM_NODE_VECTORS; ++b) at.F[b] = w->nodes.F[b], at.a[b] = w->nodes.a[b], at.series[b] = w->nodes.series[b];
    return at;
}

/* A number at each of the nodes of vector b, of row k. */
typedef em_node_vector em_term(const em_tables *at, int b, int k);

/* The sum of the squares of terms of rows first ... end. */
EM_INLINE em_node_vector em_sum_of_squares(const em_tables *at, int b, int first, int end, em_term *term) {
    em_node_vector sum[EM_SUMS] = {{0.0}};
    int k = first;
    for (; k + EM_SUMS <= end; k += EM_SUMS)
        for (int place = 0; place < EM_SUMS; ++place) {
            const em_node_vector number = term(at, b, k + place);
            sum[place] += number * number;
        }
    for (; k < end; ++k) {
        const em_node_vector number = term(at, b, k);
        sum[0] += number * number;
    }
    return (sum[0] + sum[1]) + (sum[2] + sum[3]);
}

/* Rows of the images of a linear map that are computed together: they share its coefficients, which come from
 * memory. */
enum { EM_TOGETHER = EM_LANES == 1 ? 1 : 2 };

/* out_(to + r) <- base_r (NULL: 0) + factor sum_j column_j a_(from + r)j for r below `rows`: a linear map (8, 8),
 * column by column. */
EM_INLINE void em_map_rows(int rows, const double (*column)[EM_NODE_COUNT], em_node_vector *const *a, int from,
                           const double *base, double factor, em_node_vector *const *out, int to) {
    em_node_vector sum[EM_TOGETHER][EM_NODE_VECTORS] = {{{0.0}}};
    EM_UNROLL
    for (int j = 0; j < EM_NODE_COUNT; ++j)
        for (int r = 0; r < rows; ++r)
            for (int b = 0; b < EM_NODE_VECTORS; ++b)
                sum[r][b] += em_node_vector_at(column[j] + b * EM_LANES) * em_number_at(a, from + r, j);
    for (int r = 0; r < rows; ++r)
        for (int b = 0; b < EM_NODE_VECTORS; ++b) out[b][to + r] = (base ? base[r] : 0.0) + factor * sum[r][b];
}

/* The same for any number of rows. */
EM_INLINE void em_map(int rows, const double (*column)[EM_NODE_COUNT], em_node_vector *const *a, int from,
                      const double *base, double factor, em_node_vector *const *out, int to) {
    em_node_vector *in[EM_NODE_VECTORS], *image[EM_NODE_VECTORS];
    int r = 0;
    EM_UNROLL
    for (int b = 0; b < EM_NODE_VECTORS; ++b) in[b] = a[b], image[b] = out[b];
    for (; r + EM_TOGETHER <= rows; r += EM_TOGETHER)
        em_map_rows(EM_TOGETHER, column, in, from + r, base ? base + r : NULL, factor, image, to + r);
    if (r < rows) em_map_rows(1, column, in, from + r, base ? base + r : NULL, factor, image, to + r);
}

/* sum_r (2) += both maps of a_(from + r), whose numbers are read once; otherwise compilers keep them on the stack. */
EM_INLINE void em_both_rows(int rows, const double (*first)[EM_NODE_COUNT], const double (*second)[EM_NODE_COUNT],
                            em_node_vector *const *a, int from, em_node_vector (*sum)[2][EM_NODE_VECTORS]) {
    EM_UNROLL
    for (int j = 0; j < EM_NODE_COUNT; ++j)
        for (int r = 0; r < rows; ++r) {
            const double number = em_number_at(a, from + r, j);
            for (int b = 0; b < EM_NODE_VECTORS; ++b) {
                sum[r][0][b] += em_node_vector_at(first[j] + b * EM_LANES) * number;
                sum[r][1][b] += em_node_vector_at(second[j] + b * EM_LANES) * number;
            }
        }
}

#endif
