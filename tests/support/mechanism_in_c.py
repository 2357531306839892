"""The C file of a mechanism written by hand: right-hand side, settling and events, and the stepper behind them."""

import string
from dataclasses import dataclass

from eigenmotion.arguments.methods import METHODS
from eigenmotion.building.toolchain import INCLUDE

SOURCE = string.Template(r"""
#include "eigenmotion.h"
#include "numeric/em_linear.h"
enum { N = $n, N_ROWS = 0, N_POSITIONS = 0, N_C = $n_c, N_S = $n_s, N_CD = 0, N_SD = 0 };
enum { N_STATE = 2 * N + N_C + N_S };
enum { EM_SECOND_ORDER = $second_order, N_INPUTS = $n_inputs, N_EVENTS = $n_events };
enum { N_MEMORY = $n_memory };
#define UNUSED (void)mode, (void)t, (void)y, (void)c, (void)u, (void)memory, (void)flags, (void)h, (void)fault
$preamble
static int model_rhs(int mode, double t, const double *y, const double *c, const double *u, double *memory,
                     int flags, double *dy, em_fault *fault) {
    const double h = 0.0;
    UNUSED;
    $rhs
    return 0;
}
static int model_settle(int *mode, int flags, double t, double *y, const double *c, double *memory, double h,
                        em_fault *fault) {
    const double *u = NULL;
    UNUSED;
    $settle
    return 0;
}
static void model_velocity_error(int mode, const double *y, const double *c, const double *memory, const double *e,
                                 double *ev) {
    (void)y, (void)c, (void)memory;
    for (int k = 0; k < N; ++k) ev[k] = e[k] / (mode ? 2.0 : 1.0);
}
static int model_velocity(int mode, double t, const double *y, const double *c, double *v, em_fault *fault) {
    (void)t, (void)c, (void)fault;
    for (int k = 0; k < N; ++k) v[k] = y[N + k] / (mode ? 2.0 : 1.0);
    return 0;
}
static int model_publish(int mode, double t, const double *y, const double *c, const double *memory, double *row,
                         em_fault *fault) {
    (void)memory;
    memcpy(row, y, N_STATE * sizeof *row);
    return model_velocity(mode, t, y, c, row + N, fault);
}
static void model_events(double t, const double *x, const double *v, const double *c, const double *u, double *g) {
    (void)t, (void)x, (void)v, (void)c, (void)u, (void)g;
    $events
}
#include "loop/em_stepper.h"
int simulate(em_run *run);
int interpolate(const em_run *run, size_t step, double t, double *y);
void release(em_run *run);
const em_tableau *tableau(int method);
#define METHODS {$methods}
static const em_dynamics dynamics = {
    .n_C = N_C, .n_s = N_S, .n_memory = N_MEMORY, .second_order = EM_SECOND_ORDER, .settles = $settles,
    .rhs = model_rhs, .settle = model_settle, .velocity = model_velocity, .velocity_error = model_velocity_error,
    .publish = model_publish, .events = model_events};
static const em_model model = {.n = N, .m = N_ROWS, .h = N_POSITIONS, .n_state = N_STATE, .n_inputs = N_INPUTS,
                               .n_events = N_EVENTS, .dynamics = &dynamics};
int simulate(em_run *run) { return em_simulate(&model, run); }
int interpolate(const em_run *run, size_t step, double t, double *y) { return em_interpolate(&model, run, step, t, y); }
void release(em_run *run) { em_release(&model, run); }
const em_tableau *tableau(int method) {
    static const em_tableau *const all[] = {$tableaux};
    return all[method];
}
$main
""")
STATED = (INCLUDE / "tableaux/em_butcher.h").read_text(encoding="utf-8")
NUMBERS = ", ".join(f"EM_{name.upper()}" for name in METHODS)
RUNGE_KUTTA = tuple(name for name in METHODS if f"EM_{name.upper()}_TABLEAU" in STATED)
TABLEAUX = ", ".join(f"[{METHODS[name].number}] = &EM_{name.upper()}_TABLEAU" for name in RUNGE_KUTTA)


@dataclass(frozen=True, slots=True)
class Mechanism:
    """Bodies of the C functions of a model whose eta is v in mode 0 and 2 v in mode 1."""

    rhs: str
    settle: str = ""
    events: str = ""
    preamble: str = ""
    main: str = ""
    n: int = 1
    n_c: int = 0
    n_s: int = 0
    n_inputs: int = 0
    n_events: int = 0
    n_memory: int = 0
    settles: int = 0
    second_order: int = 0

    def text(self) -> str:
        given = {name: getattr(self, name) for name in self.__slots__}
        return SOURCE.substitute(given, methods=NUMBERS, tableaux=TABLEAUX)
