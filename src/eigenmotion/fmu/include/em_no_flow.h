/* em_no_flow.h: in place of the states of em_unit.h, for units that have none to integrate: each says so.
 *
 * FMI wants the functions of model exchange in any unit; no instance of this one is made for them. */
#ifndef EM_NO_FLOW_H
#define EM_NO_FLOW_H

static int em_unit_has_no_states(em_unit *unit) {
    snprintf(unit->words, sizeof unit->words, "%s", EM_FMU_OFFERS);
    return -1;
}

static void em_unit_let_flow(em_unit *unit) { (void)unit; }
static int em_unit_set_time(em_unit *unit, double t) { return (void)t, em_unit_has_no_states(unit); }
static int em_unit_set_states(em_unit *unit, const double *states) { return (void)states, em_unit_has_no_states(unit); }
static int em_unit_states(em_unit *unit, double *states) { return (void)states, em_unit_has_no_states(unit); }
static int em_unit_rates(em_unit *unit, double *rates) { return (void)rates, em_unit_has_no_states(unit); }
static int em_unit_indicators(em_unit *unit, double *g) { return (void)g, em_unit_has_no_states(unit); }
static int em_unit_accepted(em_unit *unit, int *event) { return (void)event, em_unit_has_no_states(unit); }
static int em_unit_update(em_unit *unit, int *changed) { return (void)changed, em_unit_has_no_states(unit); }

#endif
