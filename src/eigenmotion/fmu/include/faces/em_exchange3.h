/* em_exchange3.h: the functions of FMI 3.0 for model exchange, which units that flow offer (em_flow.h). */

EM_FMU fmi3Status fmi3EnterContinuousTimeMode(fmi3Instance c) {
    (void)c;
    return fmi3OK;
}

EM_FMU fmi3Status fmi3UpdateDiscreteStates(fmi3Instance c, fmi3Boolean *again, fmi3Boolean *terminate,
                                           fmi3Boolean *nominals_changed, fmi3Boolean *states_changed,
                                           fmi3Boolean *has_next, fmi3Float64 *next) {
    em_fmu *fmu = c;
    int changed = 0;
    *again = *terminate = *nominals_changed = *states_changed = *has_next = false;
    *next = 0.0;
    if (em_unit_update(fmu->unit, &changed)) return em_answer(fmu, 1);
    *states_changed = changed;
    return fmi3OK;
}

EM_FMU fmi3Status fmi3CompletedIntegratorStep(fmi3Instance c, fmi3Boolean no_state_before, fmi3Boolean *event,
                                              fmi3Boolean *terminate) {
    em_fmu *fmu = c;
    int needed = 0;
    (void)no_state_before;
    *event = *terminate = false;
    if (em_unit_accepted(fmu->unit, &needed)) return em_answer(fmu, 1);
    *event = needed;
    return fmi3OK;
}

EM_FMU fmi3Status fmi3SetTime(fmi3Instance c, fmi3Float64 t) {
    em_fmu *fmu = c;
    return em_answer(fmu, em_unit_set_time(fmu->unit, t));
}

EM_FMU fmi3Status fmi3SetContinuousStates(fmi3Instance c, const fmi3Float64 states[], size_t count) {
    em_fmu *fmu = c;
    (void)count;
    return em_try(fmu, em_unit_set_states(fmu->unit, states));
}

EM_FMU fmi3Status fmi3GetContinuousStates(fmi3Instance c, fmi3Float64 states[], size_t count) {
    em_fmu *fmu = c;
    (void)count;
    return em_answer(fmu, em_unit_states(fmu->unit, states));
}

EM_FMU fmi3Status fmi3GetContinuousStateDerivatives(fmi3Instance c, fmi3Float64 rates[], size_t count) {
    em_fmu *fmu = c;
    (void)count;
    return em_try(fmu, em_unit_rates(fmu->unit, rates));
}

EM_FMU fmi3Status fmi3GetEventIndicators(fmi3Instance c, fmi3Float64 indicators[], size_t count) {
    em_fmu *fmu = c;
    (void)count;
    return em_try(fmu, em_unit_indicators(fmu->unit, indicators));
}

EM_FMU fmi3Status fmi3GetNominalsOfContinuousStates(fmi3Instance c, fmi3Float64 nominals[], size_t count) {
    (void)c;
    for (size_t k = 0; k < count; ++k) nominals[k] = 1.0;
    return fmi3OK;
}

EM_FMU fmi3Status fmi3GetNumberOfContinuousStates(fmi3Instance c, size_t *count) {
    *count = 2 * (size_t)((em_fmu *)c)->unit->model->n;
    return fmi3OK;
}

EM_FMU fmi3Status fmi3GetNumberOfEventIndicators(fmi3Instance c, size_t *count) {
    *count = (size_t)((em_fmu *)c)->unit->model->n_events;
    return fmi3OK;
}
