/* em_exchange2.h: the functions of FMI 2.0 for model exchange, which units that flow offer (em_flow.h). */

EM_FMU fmi2Status fmi2EnterEventMode(fmi2Component c) {
    (void)c;
    return fmi2OK;
}

EM_FMU fmi2Status fmi2EnterContinuousTimeMode(fmi2Component c) {
    (void)c;
    return fmi2OK;
}

EM_FMU fmi2Status fmi2NewDiscreteStates(fmi2Component c, fmi2EventInfo *info) {
    em_fmu *fmu = c;
    int changed = 0;
    *info = (fmi2EventInfo){0};
    if (em_unit_update(fmu->unit, &changed)) return em_answer(fmu, 1);
    info->valuesOfContinuousStatesChanged = changed;
    return fmi2OK;
}

EM_FMU fmi2Status fmi2CompletedIntegratorStep(fmi2Component c, fmi2Boolean no_state_before, fmi2Boolean *event,
                                              fmi2Boolean *terminate) {
    em_fmu *fmu = c;
    (void)no_state_before;
    *event = *terminate = 0;
    return em_answer(fmu, em_unit_accepted(fmu->unit, event));
}

EM_FMU fmi2Status fmi2SetTime(fmi2Component c, fmi2Real t) {
    em_fmu *fmu = c;
    return em_answer(fmu, em_unit_set_time(fmu->unit, t));
}

EM_FMU fmi2Status fmi2SetContinuousStates(fmi2Component c, const fmi2Real states[], size_t count) {
    em_fmu *fmu = c;
    (void)count;
    return em_try(fmu, em_unit_set_states(fmu->unit, states));
}

EM_FMU fmi2Status fmi2GetContinuousStates(fmi2Component c, fmi2Real states[], size_t count) {
    em_fmu *fmu = c;
    (void)count;
    return em_answer(fmu, em_unit_states(fmu->unit, states));
}

EM_FMU fmi2Status fmi2GetDerivatives(fmi2Component c, fmi2Real rates[], size_t count) {
    em_fmu *fmu = c;
    (void)count;
    return em_try(fmu, em_unit_rates(fmu->unit, rates));
}

EM_FMU fmi2Status fmi2GetEventIndicators(fmi2Component c, fmi2Real indicators[], size_t count) {
    em_fmu *fmu = c;
    (void)count;
    return em_try(fmu, em_unit_indicators(fmu->unit, indicators));
}

EM_FMU fmi2Status fmi2GetNominalsOfContinuousStates(fmi2Component c, fmi2Real nominals[], size_t count) {
    (void)c;
    for (size_t k = 0; k < count; ++k) nominals[k] = 1.0;
    return fmi2OK;
}
