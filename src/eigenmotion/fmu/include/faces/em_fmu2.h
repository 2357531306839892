/* em_fmu2.h: the functions of FMI 2.0, for co-simulation and model exchange; em_both.h has those that are as in 3.0. */
#include "em_face.h"
#include "em_fmi2.h"

typedef void (*em_logger)(fmi2ComponentEnvironment, fmi2String, fmi2Status, fmi2String, fmi2String, ...);

static int em_say(const em_fmu *fmu, int status, const char *words) {
    const em_logger log = (em_logger)fmu->logger;
    if (log != NULL) log(fmu->environment, fmu->name, (fmi2Status)status, "logStatusError", "%s", words);
    return status;
}

#include "em_both.h"

EM_FMU const char *fmi2GetTypesPlatform(void) { return "default"; }
EM_FMU const char *fmi2GetVersion(void) { return "2.0"; }

EM_FMU fmi2Component fmi2Instantiate(fmi2String name, fmi2Type type, fmi2String guid, fmi2String resources,
                                     const fmi2CallbackFunctions *callbacks, fmi2Boolean visible, fmi2Boolean logging) {
    (void)resources, (void)visible, (void)logging;
    em_fmu *const fmu = em_face_create(name, guid, type == fmi2CoSimulation || EM_FMU_FLOWS,
                                       callbacks == NULL ? NULL : (void (*)(void))callbacks->logger,
                                       callbacks == NULL ? NULL : callbacks->componentEnvironment);
    return type == fmi2ModelExchange ? em_face_flow(fmu) : fmu;
}

EM_FMU fmi2Status fmi2SetupExperiment(fmi2Component c, fmi2Boolean has_tolerance, fmi2Real tolerance, fmi2Real start,
                                      fmi2Boolean has_end, fmi2Real end) {
    (void)has_end, (void)end;
    return em_face_begin(c, has_tolerance, tolerance, start);
}

EM_NOTHING_TO_DO(EnterInitializationMode)

/* --- numbers --- */

EM_FMU fmi2Status fmi2GetReal(fmi2Component c, const fmi2ValueReference vr[], size_t count, fmi2Real value[]) {
    return em_face_get(c, vr, count, value);
}

EM_FMU fmi2Status fmi2SetReal(fmi2Component c, const fmi2ValueReference vr[], size_t count, const fmi2Real value[]) {
    return em_face_set(c, vr, count, value);
}

#define EM_OTHERS(name, type)                                                                                      \
    EM_FMU fmi2Status fmi2Get##name(fmi2Component c, const fmi2ValueReference vr[], size_t count, type value[]) {  \
        (void)vr, (void)value;                                                                                     \
        return em_none(c, count, "all numbers of this unit are real");                                             \
    }                                                                                                              \
    EM_FMU fmi2Status fmi2Set##name(fmi2Component c, const fmi2ValueReference vr[], size_t count,                  \
                                    const type value[]) {                                                          \
        (void)vr, (void)value;                                                                                     \
        return em_none(c, count, "all numbers of this unit are real");                                             \
    }

EM_OTHERS(Integer, fmi2Integer)
EM_OTHERS(Boolean, fmi2Boolean)
EM_OTHERS(String, fmi2String)

EM_FMU fmi2Status fmi2SetRealInputDerivatives(fmi2Component c, const fmi2ValueReference vr[], size_t count,
                                              const fmi2Integer order[], const fmi2Real value[]) {
    (void)vr, (void)order, (void)value;
    return em_none(c, count, "inputs are held during a step");
}

EM_FMU fmi2Status fmi2GetRealOutputDerivatives(fmi2Component c, const fmi2ValueReference vr[], size_t count,
                                               const fmi2Integer order[], fmi2Real value[]) {
    (void)vr, (void)order, (void)value;
    return em_none(c, count, "this unit gives no derivatives of its outputs");
}

EM_FMU fmi2Status fmi2GetDirectionalDerivative(fmi2Component c, const fmi2ValueReference unknown[], size_t unknowns,
                                               const fmi2ValueReference known[], size_t count, const fmi2Real dknown[],
                                               fmi2Real dunknown[]) {
    em_fmu *fmu = c;
    return em_answer(fmu, em_unit_along(fmu->unit, unknown, unknowns, known, count, dknown, dunknown));
}

/* --- steps --- */

EM_FMU fmi2Status fmi2DoStep(fmi2Component c, fmi2Real t, fmi2Real h, fmi2Boolean no_state_before) {
    em_fmu *fmu = c;
    (void)no_state_before;
    return em_try(fmu, em_unit_advance(fmu->unit, t + h));
}

EM_FMU fmi2Status fmi2CancelStep(fmi2Component c) { return em_say(c, fmi2Error, "no step is under way"); }

EM_FMU fmi2Status fmi2GetStatus(fmi2Component c, fmi2StatusKind kind, fmi2Status *value) {
    (void)c, (void)kind;
    *value = fmi2OK;
    return fmi2OK;
}

/* The time that was reached: after fmi2Discard the unit stands there. */
EM_FMU fmi2Status fmi2GetRealStatus(fmi2Component c, fmi2StatusKind kind, fmi2Real *value) {
    if (kind != fmi2LastSuccessfulTime) return em_say(c, fmi2Discard, "no such status");
    *value = em_unit_time(((em_fmu *)c)->unit);
    return fmi2OK;
}

EM_FMU fmi2Status fmi2GetIntegerStatus(fmi2Component c, fmi2StatusKind kind, fmi2Integer *value) {
    (void)kind, (void)value;
    return em_say(c, fmi2Discard, "no such status");
}

EM_FMU fmi2Status fmi2GetBooleanStatus(fmi2Component c, fmi2StatusKind kind, fmi2Boolean *value) {
    if (kind != fmi2Terminated) return em_say(c, fmi2Discard, "no such status");
    *value = 0;
    return fmi2OK;
}

EM_FMU fmi2Status fmi2GetStringStatus(fmi2Component c, fmi2StatusKind kind, fmi2String *value) {
    (void)kind;
    *value = ((em_fmu *)c)->unit->words;
    return fmi2OK;
}

/* --- model exchange --- */

EM_FMU fmi2Status fmi2NewDiscreteStates(fmi2Component c, fmi2EventInfo *info) {
    em_fmu *fmu = c;
    int changed = 0;
    *info = (fmi2EventInfo){0};
    if (em_unit_update(fmu->unit, &changed)) return em_answer(fmu, 1);
    info->valuesOfContinuousStatesChanged = changed;
    return fmi2OK;
}
