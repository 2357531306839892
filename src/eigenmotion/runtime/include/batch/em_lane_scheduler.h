/* em_lane_scheduler.h: the lane scheduler: puts the members of an ensemble into lanes (em_lane_runge_kutta.h).
 *
 * All runs of a lane group are in one mode. A run whose mode changes leaves its lane and waits for one in the other
 * group. A group continues as long as it has no empty lane. So few runs wait, and all lanes are in use until few
 * members are left. */
#ifndef EM_LANE_SCHEDULER_H
#define EM_LANE_SCHEDULER_H

#include <stdint.h>

#include "batch/em_members.h"
#include "loop/em_subnormals.h"

enum { EM_MOST_MODES = 2, EM_SLOTS = EM_MOST_MODES * EM_MOST_LANES };

/* A slot: a run in progress, its member, and its memory. */
typedef struct em_slot {
    em_run run;
    void *run_state;
    size_t member;
    double *c, *y;
    int taken;
} em_slot;

typedef struct em_lane_scheduler {
    em_ensemble *e;
    em_lane_group groups[EM_MOST_MODES];
    em_slot slots[EM_SLOTS];
    em_slot *in_lane[EM_MOST_MODES][EM_MOST_LANES], *waiting[EM_MOST_MODES][EM_SLOTS];
    int n_waiting[EM_MOST_MODES], modes, width, stopped;
    size_t next;
} em_lane_scheduler;

/* Whether runs of this task are computed in lanes, except members with redundant rows. This depends only on the task
 * and the model, so that it is the same for all members. */
static int em_ensemble_has_lanes(const em_ensemble *e) {
    const em_model *model = e->model;
    if (model->enter == NULL || model->lanes == NULL || model->lanes->run == NULL || model->lanes->width < 2) return 0;
    if (e->task.method != EM_DOP853 || model->lanes->width > EM_MOST_LANES) return 0;
    return (model->m == 0 && model->lanes->remembered == 0) || (e->task.stabilise && e->task.least_norm != EM_SHARED);
}

/* Whether a member's inputs are constant, as lanes require. */
static int em_has_constant_inputs(const em_ensemble *e, size_t member) {
    const em_signal *inputs = e->inputs ? e->inputs + member * e->inputs_stride : NULL;
    for (int k = 0; k < e->model->n_inputs; ++k)
        if (inputs[k].kind != EM_CONSTANT) return 0;
    return 1;
}

/* Frees the slot of a run that has ended. kept: its results are stored; otherwise the scalar code repeats the run. */
static void em_leave_lane(em_lane_scheduler *w, em_slot *slot, int kept) {
    em_ensemble *const e = w->e;
    if (slot->run_state != NULL) e->model->close(slot->run_state);
    if (kept) em_ensemble_keep(e, slot->member, &slot->run);
    e->model->release(&slot->run);
    if (!kept) em_ensemble_member(e, slot->member, slot->c, slot->y);
    slot->taken = 0;
}

static em_slot *em_free_slot(em_lane_scheduler *w) {
    em_slot *slot = w->slots;
    while (slot->taken) ++slot;
    return slot;
}

/* Starts the next member in a free slot, where it waits for a lane of its mode; if lanes cannot compute it, the scalar
 * code runs it to its end. */
static void em_start_member(em_lane_scheduler *w) {
    em_ensemble *const e = w->e;
    em_slot *const slot = em_free_slot(w);
    em_run *const run = &slot->run;
    int mode = 0;
    slot->member = w->next++;
    slot->run_state = NULL;
    slot->taken = 1;
    *run = e->task;
    if (!em_ensemble_stopped(e) && em_has_constant_inputs(e, slot->member) &&
        em_ensemble_start(e, slot->member, slot->c, slot->y, &run->fault) == 0) {
        run->prepared = slot->c;
        run->y_start = slot->y;
        run->inputs = e->inputs ? e->inputs + slot->member * e->inputs_stride : NULL;
        slot->run_state = e->model->enter(run, &mode);
    }
    if (slot->run_state == NULL) em_leave_lane(w, slot, 0);
    else w->waiting[mode][w->n_waiting[mode]++] = slot;
}

/* How many lanes of a group could be in use; members not yet started count as of mode 0. */
static size_t em_usable_lanes(const em_lane_scheduler *w, int mode) {
    const size_t here = (size_t)(w->groups[mode].n_live + w->n_waiting[mode]);
    const size_t more = mode == 0 ? w->e->count - w->next : 0;
    return here + more < (size_t)w->width ? here + more : (size_t)w->width;
}

/* Whether the other group should continue first. */
static int em_yields_lane(const em_lane_scheduler *w, int mode) {
    if (w->modes == 1) return 0;
    const size_t other = em_usable_lanes(w, !mode);
    return other > em_usable_lanes(w, mode) || (mode == 0 && other == (size_t)w->width);
}

/* Loads a run into an empty lane, unless the group yields to the other; if no run is left, the lane stays idle. */
static void em_fill_lane(em_lane_scheduler *w, int mode, int lane) {
    em_lane_group *const f = &w->groups[mode];
    while (!(f->yields = em_yields_lane(w, mode)) && mode == 0 && w->n_waiting[0] == 0 && w->next < w->e->count)
        em_start_member(w);
    f->live[lane] = !f->yields && w->n_waiting[mode] > 0;
    f->n_live += f->live[lane];
    if (f->live[lane]) {
        em_slot *const slot = w->in_lane[mode][lane] = w->waiting[mode][--w->n_waiting[mode]];
        w->e->model->load(slot->run_state, f, lane);
        return;
    }
    f->t[lane] = f->task->t_end;
    f->h_next[lane] = 0.0;
}

/* em_lane_group.check_step */
static int em_ensemble_check_step(em_lane_group *f, int lane, em_lane_outcome outcome) {
    enum { RESTARTS = -1, CONTINUES, ENDED, CHANGES_MODE };
    em_lane_scheduler *const w = f->owner;
    em_slot *const slot = w->in_lane[f->mode][lane];
    const int result = outcome == EM_LOST ? RESTARTS : w->e->model->check_step(slot->run_state, f, lane, outcome);
    if (result == CONTINUES) return 0;
    f->live[lane] = 0;
    --f->n_live;
    if (result == CHANGES_MODE) w->waiting[!f->mode][w->n_waiting[!f->mode]++] = slot;
    else em_leave_lane(w, slot, result == ENDED);
    em_fill_lane(w, f->mode, lane);
    return 1;
}

/* em_lane_group.stopped */
static int em_ensemble_all_stop(em_lane_group *f) {
    em_lane_scheduler *const w = f->owner;
    return w->stopped = em_ensemble_stopped(w->e);
}

/* Ends the runs that were in progress when an end was requested. */
static void em_ensemble_interrupt(em_lane_scheduler *w) {
    for (em_slot *slot = w->slots; slot < w->slots + EM_SLOTS; ++slot) {
        if (!slot->taken) continue;
        slot->run.fault = (em_fault){EM_INTERRUPTED, -1, -1, 0.0};
        for (int mode = 0; mode < w->modes; ++mode)
            for (int lane = 0; lane < w->width; ++lane)
                if (w->in_lane[mode][lane] == slot && w->groups[mode].live[lane]) slot->run.t_reached = w->groups[mode].t[lane];
        em_leave_lane(w, slot, 1);
    }
    while (w->next < w->e->count) em_ensemble_member(w->e, w->next++, w->slots->c, w->slots->y);
}

/* Takes the next numbers of a block of memory. */
static double *em_take_block(double **place, size_t size) {
    double *const piece = *place;
    *place += size;
    return piece;
}

enum { EM_GROUP_STEPS = 12, EM_GROUP_NUMBERS = 16 };

/* The size of all tables of a lane group, in numbers. */
static size_t em_group_size(const em_model *model) {
    const size_t states = ((size_t)model->n_state + 3) / 4 * 4, memory = 2 * (size_t)model->lanes->remembered;
    const size_t rows = (EM_GROUP_STEPS + 3) * states + memory + (size_t)model->n_prepared + (size_t)model->n_inputs;
    return (rows + EM_GROUP_NUMBERS) * (size_t)model->lanes->width;
}

/* Lays out the tables of a lane group one after the other. */
static void em_group_tables(em_lane_group *f, const em_model *model, double *place) {
    const size_t width = (size_t)model->lanes->width, states = ((size_t)model->n_state + 3) / 4 * 4;
    const size_t memory = (size_t)model->lanes->remembered;
    double **const tables[] = {&f->K, &f->y, &f->y_new, &f->f_new, &f->memory, &f->memory_new, &f->c, &f->u};
    const size_t sizes[] = {EM_GROUP_STEPS * states, states, states, states, memory, memory, (size_t)model->n_prepared,
                            (size_t)model->n_inputs};
    double **const numbers[EM_GROUP_NUMBERS] = {
        &f->t, &f->t_new, &f->h, &f->h_next, &f->error, &f->last_error, &f->longest, &f->n_steps, &f->n_rejected,
        &f->retries, &f->n_rhs, &f->stiff, &f->n_stiff, &f->next_stiffness_check, &f->next_check, &f->t_check};
    for (size_t k = 0; k < sizeof sizes / sizeof *sizes; ++k) *tables[k] = em_take_block(&place, sizes[k] * width);
    for (int k = 0; k < EM_GROUP_NUMBERS; ++k) *numbers[k] = em_take_block(&place, width);
}

static void em_group_begin(em_lane_scheduler *w, int mode, double *place) {
    const em_run *const task = &w->e->task;
    em_lane_group *const f = &w->groups[mode];
    *f = (em_lane_group){.task = task, .mode = mode, .owner = w};
    f->check_step = em_ensemble_check_step, f->stopped = em_ensemble_all_stop;
    f->rtol = task->rtol > 100.0 * DBL_EPSILON ? task->rtol : 100.0 * DBL_EPSILON;
    f->direction = task->t_end < task->t_start ? -1.0 : 1.0;
    f->stretch = pow(f->rtol, -1.0 / 8.0);
    f->check_always = w->e->model->n_events > 0 || f->rtol > 1e-5; /* EM_LOOSE of em_singularity_monitor.h */
    em_group_tables(f, w->e->model, place);
}

/* Allocates all memory in one block and returns it, or NULL. */
static double *em_lane_scheduler_open(em_lane_scheduler *w) {
    enum { LINE = 8 };
    const em_model *model = w->e->model;
    const size_t c = (size_t)model->n_prepared + 1, n = (size_t)model->n_state, group = em_group_size(model);
    double *const block = calloc((size_t)w->modes * group + LINE + EM_SLOTS * (c + n), sizeof *block);
    if (block == NULL) return NULL;
    double *place = (double *)(((uintptr_t)block + LINE * sizeof *block - 1) / (LINE * sizeof *block) * (LINE * sizeof *block));
    for (int mode = 0; mode < w->modes; ++mode) em_group_begin(w, mode, em_take_block(&place, group));
    for (int k = 0; k < EM_SLOTS; ++k) {
        w->slots[k].c = em_take_block(&place, c);
        w->slots[k].y = em_take_block(&place, n);
    }
    return block;
}

/* Fills the empty lanes and continues the group until it yields to the other. */
static void em_group_continue(em_lane_scheduler *w, int mode) {
    em_lane_group *const f = &w->groups[mode];
    for (int lane = 0; lane < w->width; ++lane)
        if (!f->live[lane]) em_fill_lane(w, mode, lane);
    if (f->n_live > 0 && !f->yields) w->e->model->lanes->run(f);
}

/* Runs all members in lanes, as far as possible. 0, or -1 without memory. */
static int em_ensemble_in_lanes(em_ensemble *e) {
    em_lane_scheduler w = {.e = e, .modes = e->model->lanes->modes, .width = e->model->lanes->width};
    double *const block = em_lane_scheduler_open(&w);
    if (block == NULL) return -1;
    for (int mode = 0; em_usable_lanes(&w, mode) > 0 && !w.stopped; mode = em_yields_lane(&w, mode) ? !mode : mode)
        em_group_continue(&w, mode);
    em_ensemble_interrupt(&w);
    free(block);
    return 0;
}

/* Runs every member of an ensemble. 0, or -1 without memory. */
static int em_ensemble_run(em_ensemble *e) {
    const uint64_t subnormals = em_flush_subnormals();
    timespec_get(&e->polled, TIME_UTC);
    const int status = em_ensemble_has_lanes(e) ? em_ensemble_in_lanes(e) : em_ensemble_scalar(e, 0, e->count);
    em_restore_subnormals(subnormals);
    return status;
}

#endif
