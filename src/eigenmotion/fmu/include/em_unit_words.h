/* em_unit_words.h: messages of units about faults, and about numbers that they do not take. */
#ifndef EM_UNIT_WORDS_H
#define EM_UNIT_WORDS_H

#include <stdio.h>

#include "eigenmotion.h"
#include "loop/em_assumptions.h"

enum { EM_WORDS = 512 };

/* -1, and words (EM_WORDS) that say where a fault sits. */
static int em_words_of_fault(const em_model *m, const em_fault *fault, double t, char *words) {
    static const char *const reasons[] = {
        "finished", "terminal event", "step size underflow", "too many steps", "the state is not finite",
        "singular mass matrix", "dependent constraints", "coincident eigenvalues", "position not reached", "interrupted",
        "out of memory", "eigenfactors drifted", "an event has no value", "energy drifted", "constraints drifted",
        "no motion starts there", "events pile up", "an impact has no solution", "a reset leaves the constraints",
        "the model jumps", "a reset ends inside an impact", "contacts clash", "a value that was not declared",
        "the motion leaves the range of a table"};
    const size_t count = sizeof reasons / sizeof *reasons, status = (size_t)fault->status;
    const int row = fault->status == EM_DEPENDENT_CONSTRAINTS || fault->status == EM_POSITION_NOT_REACHED ||
                    fault->status == EM_CONSTRAINTS_DRIFTED;
    const int named = !row && fault->status != EM_OUTSIDE_TABLE && fault->first >= 0 && fault->first < m->n;
    const char *const reason = status < count ? reasons[status] : "failed";
    if (fault->status == EM_OUTSIDE_TABLE)
        snprintf(words, EM_WORDS, "at t = %.9g: %s %s, at %.9g", t, reason,
                 m->parameters[m->tables[fault->first].parameter], fault->size);
    else if (row) snprintf(words, EM_WORDS, "at t = %.9g: %s, row %d", t, reason, fault->first);
    else snprintf(words, EM_WORDS, "at t = %.9g: %s%s%s", t, reason, named ? ", coordinate " : "",
                  named ? m->coordinates[fault->first] : "");
    return -1;
}

/* What a parameter is if it is a table, which a unit does not change; otherwise NULL. */
static const char *em_unit_table(const em_model *m, int parameter) {
    for (int k = 0; k < m->n_tables; ++k)
        if (parameter == m->tables[k].parameter) return m->tables[k].is_input ? "prescribes a motion" : "is a table";
    return NULL;
}

/* -1, and words: the symbol in this place, among parameters, x and inputs (-1: none of them), does not take a value. */
static int em_words_of_value(const em_model *m, int place, double value, char *words) {
    em_fault fault;
    const char *const table = em_unit_table(m, place);
    if (value != 0.0 && table != NULL) {
        snprintf(words, EM_WORDS, "%s %s, which a unit has as it was exported: leave it at 0", m->parameters[place], table);
        return -1;
    }
    if (place < 0 || m->declared == NULL || !em_check_declared(m->declared, place, 1, &value, &fault)) return 0;
    const int x = m->n_parameters, u = x + m->n;
    const char *const name = place < x ? m->parameters[place] : place < u ? m->coordinates[place - x] : m->inputs[place - u];
    snprintf(words, EM_WORDS, "%s = %.9g, but it was declared %s", name, value, m->declared[place].words);
    return -1;
}

/* -1, and words. */
static int em_words_of_no_reference(unsigned reference, char *words) {
    snprintf(words, EM_WORDS, "value reference %u: there is none", reference);
    return -1;
}

#endif
