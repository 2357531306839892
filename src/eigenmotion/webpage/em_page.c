/* em_page.c: one model behind a few functions that a page calls. Compiled with NAME.c to WebAssembly.
 *
 * Everything the page reads is one table (n_rows, width) of doubles, a row a time:
 * t, x (n), v (n), energy, |A v + b|, |phi|, lambda (m), outputs (n_outputs), the numbers of the drawing. */
#include <stdlib.h>
#include <string.h>

#include "numeric/em_linear.h"

extern const em_model EM_PAGE_MODEL;
static const em_model *const model = &EM_PAGE_MODEL;

static struct page {
    double *parameters, *inputs, *x, *v, *y, *prepared, *atol, *t_eval, *table;
    double *A, *b, *phi, *terms, *a;
    em_signal *signals;
    em_fault fault;
    int n_drawn, n_rows, polls;
    long n_rhs, n_steps;
    double t_reached;
} page;

#define EXPORTED(name) __attribute__((export_name(#name)))

static double *numbers(size_t count) { return calloc(count + 1, sizeof(double)); }

EXPORTED(open) int em_page_open(void) {
    const size_t n = (size_t)model->n, m = (size_t)model->m;
    for (int k = 0; k < model->n_shapes; ++k) page.n_drawn = model->shapes[k].first + model->shapes[k].count;
    page.parameters = numbers((size_t)model->n_parameters), page.inputs = numbers((size_t)model->n_inputs);
    page.x = numbers(n), page.v = numbers(n), page.y = numbers((size_t)model->n_state), page.atol = numbers(n);
    page.prepared = numbers((size_t)model->n_prepared);
    page.A = numbers(m * n), page.b = numbers(m), page.phi = numbers(m), page.terms = numbers(m), page.a = numbers(n);
    page.signals = calloc((size_t)model->n_inputs + 1, sizeof *page.signals);
    if (!page.signals || !page.a || !page.prepared) return -1;
    memcpy(page.parameters, model->parameter_defaults, (size_t)model->n_parameters * sizeof(double));
    memcpy(page.inputs, model->input_defaults, (size_t)model->n_inputs * sizeof(double));
    memcpy(page.x, model->initial_x, n * sizeof(double));
    memcpy(page.v, model->initial_v, n * sizeof(double));
    for (int k = 0; k < model->n_inputs; ++k) page.signals[k].values = page.inputs + k;
    return 0;
}

EXPORTED(parameters) double *em_page_parameters(void) { return page.parameters; }
EXPORTED(inputs) double *em_page_inputs(void) { return page.inputs; }
EXPORTED(x) double *em_page_x(void) { return page.x; }
EXPORTED(v) double *em_page_v(void) { return page.v; }
EXPORTED(table) double *em_page_table(void) { return page.table; }
EXPORTED(rows) int em_page_rows(void) { return page.n_rows; }
EXPORTED(width) int em_page_width(void) { return 1 + 2 * model->n + 3 + model->m + model->n_outputs + page.n_drawn; }
EXPORTED(reached) double em_page_reached(void) { return page.t_reached; }
EXPORTED(rhs_calls) int em_page_rhs_calls(void) { return (int)page.n_rhs; }
EXPORTED(steps) int em_page_steps(void) { return (int)page.n_steps; }
EXPORTED(fault_first) int em_page_fault_first(void) { return page.fault.first; }

static int failed(void) { return page.fault.status ? (int)page.fault.status : EM_NON_FINITE_STATE; }

/* Put x, v (in place) on the constraints, by Newton's steps in the mass metric. Returns an em_status. */
EXPORTED(settle) int em_page_settle(int least_norm) {
    memset(&page.fault, 0, sizeof page.fault);
    page.fault.first = -1;
    if (model->prepare(page.parameters, page.prepared, &page.fault)) return failed();
    if (model->project(0.0, page.x, page.v, page.prepared, least_norm, &page.fault)) return failed();
    return 0;
}

/* The largest |A v + b| and |phi| at a row. */
static void residuals(double t, const double *x, const double *v, double *rates, double *positions) {
    *rates = *positions = 0.0;
    if (model->m > 0) model->pfaffian(t, x, page.prepared, page.A, page.b);
    for (int row = 0; row < model->m; ++row) {
        double sum = page.b[row];
        for (int k = 0; k < model->n; ++k) sum += page.A[row * model->n + k] * v[k];
        *rates = fmax(*rates, fabs(sum));
    }
    if (model->h > 0) model->position(t, x, page.prepared, page.phi, page.terms);
    for (int row = 0; row < model->h; ++row) *positions = fmax(*positions, fabs(page.phi[row]));
}

static void fill_row(double t, const double *y, int least_norm, double *row) {
    em_fault fault;
    double *x = row + 1, *v = x + model->n, *rest = v + model->n, e[4];
    double *lambda = rest + 3, *outputs = lambda + model->m;
    row[0] = t;
    memcpy(x, y, (size_t)model->n * sizeof(double));
    if (model->velocity(t, y, page.prepared, v, &fault)) v[0] = NAN;
    model->energy(t, x, v, page.prepared, e);
    rest[0] = model->conserves_energy ? e[0] - e[2] + e[3] : e[0] + e[1] + e[2] + e[3];
    residuals(t, x, v, rest + 1, rest + 2);
    if (model->m > 0 && model->acceleration(t, x, v, page.prepared, page.inputs, least_norm, page.a, lambda, &fault))
        for (int k = 0; k < model->m; ++k) lambda[k] = NAN;
    if (model->n_outputs > 0 && model->output(t, x, v, page.prepared, page.inputs, least_norm, outputs, &fault))
        for (int k = 0; k < model->n_outputs; ++k) outputs[k] = NAN;
    if (page.n_drawn > 0) model->draw(t, x, v, page.prepared, outputs + model->n_outputs);
}

/* page.prepared <- the constants of the segment of a row, if the row is its first. Returns the index of the next segment. */
static size_t mode_at(const em_run *run, size_t row, size_t segment) {
    const em_rows *const segments = &run->segments;
    const size_t last = segments->width - 1;
    while (segment < segments->count && segments->y[segment * segments->width + last] <= (double)row) {
        memcpy(page.prepared, segments->y + segment * segments->width, last * sizeof(double));
        ++segment;
    }
    return segment;
}

static int fill_table(const em_run *run, int least_norm) {
    const size_t width = (size_t)em_page_width();
    size_t segment = 0;
    page.n_rows = (int)run->rows.count;
    free(page.table);
    page.table = numbers(width * run->rows.count);
    if (!page.table) return EM_OUT_OF_MEMORY;
    for (size_t k = 0; k < run->rows.count; ++k) {
        segment = mode_at(run, k, segment);
        fill_row(run->rows.t[k], run->rows.y + k * (size_t)model->n_state, least_norm, page.table + k * width);
    }
    return 0;
}

/* Called about every 20 ms of a run. */
static int out_of_time(void *argument) {
    (void)argument;
    return --page.polls < 0;
}

/* Run from x, v to t_end, `rows` rows at equal times; it may take `seconds`. Returns an em_status. */
EXPORTED(run) int em_page_run(double t_end, double rtol, double atol, int rows, int least_norm, double seconds) {
    em_run run;
    memset(&run, 0, sizeof run);
    memset(&page.fault, 0, sizeof page.fault);
    memset(page.y, 0, (size_t)model->n_state * sizeof(double));
    page.fault.first = -1, page.n_rows = 0, page.polls = (int)(seconds * 50.0);
    if (model->prepare(page.parameters, page.prepared, &page.fault)) return failed();
    if (model->state(0.0, page.x, page.v, page.prepared, page.y, &page.fault)) return failed();
    page.t_eval = realloc(page.t_eval, (size_t)rows * sizeof(double));
    if (!page.t_eval) return EM_OUT_OF_MEMORY;
    for (int k = 0; k < rows; ++k) page.t_eval[k] = k == rows - 1 ? t_end : t_end * k / (rows - 1);
    for (int k = 0; k < model->n; ++k) page.atol[k] = atol;
    run.model = model, run.prepared = page.prepared, run.inputs = page.signals, run.method = EM_DOP853;
    run.t_end = t_end, run.y_start = page.y, run.rtol = rtol, run.atol = page.atol;
    run.max_step = INFINITY, run.max_steps = 10000000, run.stabilise = 1, run.least_norm = least_norm;
    run.t_eval = page.t_eval, run.n_t_eval = (size_t)rows;
    run.event_direction = model->event_direction, run.event_terminal = model->event_terminal;
    run.poll = out_of_time;
    const int status = model->simulate(&run);
    page.fault = run.fault, page.n_rhs = run.n_rhs, page.n_steps = run.n_steps, page.t_reached = run.t_reached;
    const int full = fill_table(&run, least_norm);
    model->release(&run);
    return full ? full : status;
}
