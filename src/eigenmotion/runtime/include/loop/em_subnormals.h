/* em_subnormals.h: while runs are integrated, subnormal numbers (below 2.2e-308) count as zero.
 *
 * A coordinate that comes to rest decays to them, and stays there: the smallest ones are rounded to themselves. An
 * operation with one takes processors many times longer (benchmarks/subnormals.py), and none of them has a digit that
 * counts. x86 and ARM have a switch for this in a register of the thread; elsewhere nothing changes. */
#ifndef EM_SUBNORMALS_H
#define EM_SUBNORMALS_H

#include <stdint.h>

#if defined(__SSE2__)
#include <xmmintrin.h>
enum { EM_FLUSH_RESULTS = 0x8000, EM_FLUSH_OPERANDS = 0x0040 };

static inline uint64_t em_float_control(void) { return _mm_getcsr(); }
static inline void em_set_float_control(uint64_t control) { _mm_setcsr((unsigned)control); }
static const uint64_t em_flushing = EM_FLUSH_RESULTS | EM_FLUSH_OPERANDS;
#elif defined(__aarch64__)
static inline uint64_t em_float_control(void) {
    uint64_t control;
    __asm__ volatile("mrs %0, fpcr" : "=r"(control));
    return control;
}
static inline void em_set_float_control(uint64_t control) { __asm__ volatile("msr fpcr, %0" : : "r"(control)); }
static const uint64_t em_flushing = UINT64_C(1) << 24;
#else
static inline uint64_t em_float_control(void) { return 0; }
static inline void em_set_float_control(uint64_t control) { (void)control; }
static const uint64_t em_flushing = 0;
#endif

/* Lets subnormal numbers be zero in this thread. Returns what em_restore_subnormals needs. */
static inline uint64_t em_flush_subnormals(void) {
    const uint64_t before = em_float_control();
    if ((before & em_flushing) != em_flushing) em_set_float_control(before | em_flushing);
    return before;
}

static inline void em_restore_subnormals(uint64_t before) {
    if ((before & em_flushing) != em_flushing) em_set_float_control(before);
}

#endif
