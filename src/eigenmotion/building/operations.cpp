// Counter of additions, multiplications, divisions and function calls that one right-hand side executes, in loops too:
// compiles the generated C with a counting number type. SOURCE: the file; MODEL: its em_model.
#include <cfloat>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <type_traits>
#include <vector>

static long additions, multiplications, divisions, calls;

struct Counted {
    double v;
    Counted() = default;
    template <class T, class = std::enable_if_t<std::is_arithmetic_v<T> || std::is_enum_v<T>>> constexpr Counted(T number) : v(number) {}
    explicit operator int() const { return (int)v; }
    explicit operator long() const { return (long)v; }
};

#define OPERATOR(op, count)                                                                    \
    static inline Counted operator op(Counted a, Counted b) { return ++count, a.v op b.v; }     \
    static inline Counted &operator op##=(Counted &a, Counted b) { return ++count, a.v op##= b.v, a; }
OPERATOR(+, additions) OPERATOR(-, additions) OPERATOR(*, multiplications) OPERATOR(/, divisions)
static inline Counted operator-(Counted a) { return -a.v; }

#define COMPARISON(op) static inline bool operator op(Counted a, Counted b) { return a.v op b.v; }
COMPARISON(<) COMPARISON(>) COMPARISON(<=) COMPARISON(>=) COMPARISON(==) COMPARISON(!=)

#define FUNCTION(f) static inline Counted f(Counted a) { return ++calls, std::f(a.v); }
FUNCTION(sin) FUNCTION(cos) FUNCTION(tan) FUNCTION(sqrt) FUNCTION(exp) FUNCTION(log) FUNCTION(floor)
static inline Counted pow(Counted a, Counted b) { return ++calls, std::pow(a.v, b.v); }
static inline Counted fmod(Counted a, Counted b) { return ++calls, std::fmod(a.v, b.v); }
static inline Counted fma(Counted a, Counted b, Counted c) { return a * b + c; }
static inline Counted fabs(Counted a) { return std::fabs(a.v); }
static inline Counted fmax(Counted a, Counted b) { return std::fmax(a.v, b.v); }
static inline Counted fmin(Counted a, Counted b) { return std::fmin(a.v, b.v); }
static inline Counted copysign(Counted a, Counted b) { return std::copysign(a.v, b.v); }
static inline bool isfinite(Counted a) { return std::isfinite(a.v); }
static inline bool isnan(Counted a) { return std::isnan(a.v); }
static inline bool isinf(Counted a) { return std::isinf(a.v); }
static inline Counted ldexp(Counted a, int exponent) { return std::ldexp(a.v, exponent); }
static inline Counted frexp(Counted a, int *exponent) { return std::frexp(a.v, exponent); }

#define EM_LANES 1 // no vectors: the counting type cannot be an element of one
#define EM_UNIT (EM_MODEL | EM_RHS) // other units are not linked
#define restrict __restrict__
#define double Counted
#include "numeric/em_real.h"
#undef EM_HOLDS_ANY_SIZE
#define EM_HOLDS_ANY_SIZE 1 // functions that all models share are counted, too
#include SOURCE

int main() {
    std::vector<Counted> c(MODEL.n_prepared + 1), y(N_STATE), dy(N_STATE);
    em_fault fault;
    if (MODEL.prepare(MODEL.parameter_defaults, c.data(), &fault)) return 1;
    if (MODEL.state(0.0, MODEL.initial_x, MODEL.initial_v, c.data(), y.data(), &fault)) return 1;
    additions = multiplications = divisions = calls = 0;
    if (model_rhs(0, 0.0, y.data(), c.data(), MODEL.input_defaults, nullptr, 0, dy.data(), &fault)) return 1;
    std::printf("%ld %ld %ld %ld\n", additions, multiplications, divisions, calls);
}
