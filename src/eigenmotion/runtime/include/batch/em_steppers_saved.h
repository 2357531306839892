/* em_steppers_saved.h: save and restore of em_steppers: bytes, member by member, exact to the last bit. */
#ifndef EM_STEPPERS_SAVED_H
#define EM_STEPPERS_SAVED_H

#include "batch/em_steppers.h"

/* The data saved of every member; the constants at its start, its inputs, and its motion follow. */
typedef struct em_steppers_member {
    double t;
    long n_rhs, n_steps, ended;
    em_fault fault;
} em_steppers_member;

static size_t em_steppers_motion(const em_steppers *s) {
    return s->steppers != NULL ? em_stepper_size(s->steppers[0]) : (size_t)s->model->n_state * sizeof(double);
}

/* The size of one member in bytes. */
static size_t em_steppers_size(const em_steppers *s) {
    const size_t numbers = (size_t)s->model->n_prepared + (size_t)s->model->n_inputs;
    return sizeof(em_steppers_member) + numbers * sizeof(double) + (em_steppers_motion(s) + 7) / 8 * 8;
}

/* Saves all members, em_steppers_size bytes each, a multiple of 8. */
static void em_steppers_save(const em_steppers *s, char *saved) {
    const size_t c = (size_t)s->model->n_prepared, u = (size_t)s->model->n_inputs, size = em_steppers_size(s);
    em_fault fault;
    memset(saved, 0, s->count * size);
    for (size_t k = 0; k < s->count; ++k, saved += size) {
        em_steppers_member *const kept = (em_steppers_member *)saved; /* field by field, so that the padding stays 0 */
        double *const numbers = (double *)(kept + 1);
        kept->t = s->t[k], kept->n_rhs = s->n_rhs[k], kept->n_steps = s->n_steps[k], kept->ended = s->ended[k];
        kept->fault.status = s->fault[k].status, kept->fault.first = s->fault[k].first;
        kept->fault.second = s->fault[k].second, kept->fault.size = s->fault[k].size;
        if (s->steppers != NULL && c > 0) memcpy(numbers, s->steppers[k]->c, c * sizeof *numbers);
        else em_steppers_constants(s, k, numbers);
        if (u > 0) memcpy(numbers + c, s->u + k * u, u * sizeof *numbers);
        if (s->steppers != NULL) em_stepper_save(s->steppers[k], numbers + c + u);
        else em_steppers_state(s, k, numbers + c + u, &fault);
    }
}

static void em_steppers_restore(em_steppers *s, const char *saved) {
    const size_t c = (size_t)s->model->n_prepared, u = (size_t)s->model->n_inputs, size = em_steppers_size(s);
    for (size_t k = 0; k < s->count; ++k, saved += size) {
        em_steppers_member kept;
        const double *const numbers = (const double *)(saved + sizeof kept);
        memcpy(&kept, saved, sizeof kept);
        if (u > 0) memcpy(s->u + k * u, numbers + c, u * sizeof *numbers);
        if (s->steppers == NULL) em_steppers_put(s, k, kept.t, numbers + c + u, numbers);
        else {
            if (c > 0) memcpy(s->steppers[k]->c, numbers, c * sizeof *numbers);
            s->steppers[k]->run.prepared = s->steppers[k]->c;
            em_stepper_restore(s->steppers[k], numbers + c + u);
            em_steppers_read(s, k);
        }
        s->n_rhs[k] = kept.n_rhs;
        s->n_steps[k] = kept.n_steps;
        s->ended[k] = (unsigned char)kept.ended;
        s->fault[k] = kept.fault;
    }
}

#endif
