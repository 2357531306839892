/* em_both.h: functions that FMI 2.0 and 3.0 have alike; EM_FMI gives a name the prefix of the version, and EM_FMI_STATE
 * the name of a function of saved states. Those of model exchange are for units that flow (em_flow.h). */

EM_FMU EM_FMI(Status) EM_FMI(SetDebugLogging)(void *c, EM_FMI(Boolean) on, size_t count, const EM_FMI(String) categories[]) {
    (void)c, (void)on, (void)count, (void)categories;
    return EM_FMI(OK); /* errors are said, and there is nothing else */
}

EM_FMU void EM_FMI(FreeInstance)(void *c) { em_face_free(c); }

EM_FMU EM_FMI(Status) EM_FMI(ExitInitializationMode)(void *c) {
    em_fmu *fmu = c;
    return em_answer(fmu, em_unit_enter(fmu->unit));
}

EM_FMU EM_FMI(Status) EM_FMI(Reset)(void *c) {
    em_unit_reset(((em_fmu *)c)->unit);
    return EM_FMI(OK);
}

#define EM_NOTHING_TO_DO(name) \
    EM_FMU EM_FMI(Status) EM_FMI(name)(void *c) { return (void)c, EM_FMI(OK); }

EM_NOTHING_TO_DO(Terminate)
EM_NOTHING_TO_DO(EnterEventMode)
EM_NOTHING_TO_DO(EnterContinuousTimeMode)

/* --- the state --- */

EM_FMU EM_FMI(Status) EM_FMI_STATE(Get,)(void *c, void **state) { return em_face_save(c, state); }

EM_FMU EM_FMI(Status) EM_FMI_STATE(Set,)(void *c, void *state) {
    em_fmu *fmu = c;
    return em_answer(fmu, em_unit_restore(fmu->unit, state));
}

EM_FMU EM_FMI(Status) EM_FMI_STATE(Free,)(void *c, void **state) { return (void)c, em_face_forget(state); }

EM_FMU EM_FMI(Status) EM_FMI_STATE(Serialized, Size)(void *c, void *state, size_t *size) {
    (void)state;
    *size = em_unit_size(((em_fmu *)c)->unit);
    return EM_FMI(OK);
}

EM_FMU EM_FMI(Status) EM_FMI_STATE(Serialize,)(void *c, void *state, EM_FMI(Byte) bytes[], size_t size) {
    return em_face_pack(c, state, bytes, size);
}

EM_FMU EM_FMI(Status) EM_FMI_DESERIALIZE(void *c, const EM_FMI(Byte) bytes[], size_t size, void **state) {
    return em_face_unpack(c, bytes, size, state);
}

/* --- model exchange --- */

EM_FMU EM_FMI(Status) EM_FMI(CompletedIntegratorStep)(void *c, EM_FMI(Boolean) no_state_before, EM_FMI(Boolean) *event,
                                                      EM_FMI(Boolean) *terminate) {
    em_fmu *fmu = c;
    int needed = 0;
    (void)no_state_before;
    *event = *terminate = 0;
    if (em_unit_accepted(fmu->unit, &needed)) return em_answer(fmu, 1);
    *event = needed != 0;
    return EM_FMI(OK);
}

EM_FMU EM_FMI(Status) EM_FMI(SetTime)(void *c, double t) {
    em_fmu *fmu = c;
    return em_answer(fmu, em_unit_set_time(fmu->unit, t));
}

EM_FMU EM_FMI(Status) EM_FMI(SetContinuousStates)(void *c, const double states[], size_t count) {
    em_fmu *fmu = c;
    (void)count;
    return em_try(fmu, em_unit_set_states(fmu->unit, states));
}

EM_FMU EM_FMI(Status) EM_FMI(GetContinuousStates)(void *c, double states[], size_t count) {
    em_fmu *fmu = c;
    (void)count;
    return em_answer(fmu, em_unit_states(fmu->unit, states));
}

EM_FMU EM_FMI(Status) EM_FMI_RATES(void *c, double rates[], size_t count) {
    em_fmu *fmu = c;
    (void)count;
    return em_try(fmu, em_unit_rates(fmu->unit, rates));
}

EM_FMU EM_FMI(Status) EM_FMI(GetEventIndicators)(void *c, double indicators[], size_t count) {
    em_fmu *fmu = c;
    (void)count;
    return em_try(fmu, em_unit_indicators(fmu->unit, indicators));
}

EM_FMU EM_FMI(Status) EM_FMI(GetNominalsOfContinuousStates)(void *c, double nominals[], size_t count) {
    (void)c;
    for (size_t k = 0; k < count; ++k) nominals[k] = 1.0;
    return EM_FMI(OK);
}
