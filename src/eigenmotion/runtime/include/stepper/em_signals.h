/* em_signals.h: signals u(t), the inputs that are set at run time.
 *
 * Interval j of a sampled signal lies between times[j] and times[j + 1]; intervals -1 and count - 1 lie outside the
 * samples, where the value at the nearest end holds. A step never crosses a sample of EM_HOLD or EM_LINEAR, nor the
 * first and last of EM_CUBIC. The intervals are therefore looked up once per step, and all stages see one smooth
 * function. Methods that average linear signals (em_signal_averages.h) do cross their samples. */
#ifndef EM_SIGNALS_H
#define EM_SIGNALS_H

#include "numeric/em_linear.h"

/* The interval just after t in the direction of time: -1 .. count - 1. */
static long em_signal_interval(const em_signal *u, double t, double direction) {
    size_t below = 0, above = u->count; /* times[0 .. below) lie before t, times[above ..) do not */
    while (below < above) {
        const size_t middle = below + (above - below) / 2;
        const int passed = direction > 0.0 ? u->times[middle] <= t : u->times[middle] < t;
        if (passed) below = middle + 1;
        else above = middle;
    }
    return (long)below - 1;
}

/* The next sample, in the direction of time, that a step must not cross; infinite after the last. */
EM_UNUSED static double em_signal_end(const em_signal *u, long piece, double direction, int averages) {
    const long last = (long)u->count - 1;
    const int crosses = u->kind == EM_CUBIC || (u->kind == EM_LINEAR && averages);
    long sample = direction > 0.0 ? piece + 1 : piece;
    if (crosses && sample > 0 && sample < last) sample = direction > 0.0 ? last : 0;
    return sample >= 0 && sample <= last ? u->times[sample] : direction * INFINITY;
}

static double em_signal_linear(const em_signal *u, long piece, double t) {
    const long last = (long)u->count - 1;
    if (piece < 0 || piece >= last) return u->values[piece < 0 ? 0 : last];
    const double *time = u->times + piece, *value = u->values + piece;
    return value[0] + (value[1] - value[0]) * ((t - time[0]) / (time[1] - time[0]));
}

/* Requires at least two samples. */
static double em_signal_cubic(const em_signal *u, double t) {
    const long last = (long)u->count - 2;
    const double inside = fmin(fmax(t, u->times[0]), u->times[u->count - 1]);
    long piece = em_signal_interval(u, inside, 1.0);
    if (piece > last) piece = last;
    const double *a = u->values + 4 * piece, x = inside - u->times[piece];
    return ((a[0] * x + a[1]) * x + a[2]) * x + a[3];
}

static double em_signal_at(const em_signal *u, long piece, double t) {
    switch (u->kind) {
        case EM_HOLD: return u->values[piece < 0 ? 0 : piece];
        case EM_LINEAR: return em_signal_linear(u, piece, t);
        case EM_CUBIC: return em_signal_cubic(u, t);
        case EM_CONSTANT: break;
    }
    return u->values[0];
}

#endif
