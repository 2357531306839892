/* em_fmu.h: the functions of a Functional Mock-up Unit 2.0 for co-simulation, over the em_unit of the header that is
 * included before: em_unit.h, motion by forces, or em_inverse_unit.h, forces by motion.
 *
 * Before it are defined EM_FMU_MODEL, an em_model; EM_FMU_GUID, of modelDescription.xml; EM_FMU_OPTIONS, em_unit_options.
 * Instances know nothing of each other. */
#include <stdlib.h>

#include "em_fmi2.h"

typedef struct em_fmu {
    em_unit *unit;
    fmi2CallbackFunctions callbacks;
    char *name;
} em_fmu;

static fmi2Status em_say(const em_fmu *fmu, fmi2Status status, const char *words) {
    if (fmu->callbacks.logger != NULL)
        fmu->callbacks.logger(fmu->callbacks.componentEnvironment, fmu->name, status, "logStatusError", "%s", words);
    return status;
}

static fmi2Status em_answer(const em_fmu *fmu, int failed) {
    return failed ? em_say(fmu, fmi2Error, fmu->unit->words) : fmi2OK;
}

static fmi2Status em_none(fmi2Component c, size_t count, const char *words) {
    return count == 0 ? fmi2OK : em_say(c, fmi2Error, words);
}

#define EM_FMU EM_FMI2_EXPORT

EM_FMU const char *fmi2GetTypesPlatform(void) { return "default"; }
EM_FMU const char *fmi2GetVersion(void) { return "2.0"; }

EM_FMU fmi2Status fmi2SetDebugLogging(fmi2Component c, fmi2Boolean on, size_t count, const fmi2String *categories) {
    (void)c, (void)on, (void)count, (void)categories;
    return fmi2OK; /* errors are said, and there is nothing else */
}

EM_FMU void fmi2FreeInstance(fmi2Component c) {
    em_fmu *fmu = c;
    if (fmu == NULL) return;
    em_unit_free(fmu->unit);
    free(fmu->name);
    free(fmu);
}

EM_FMU fmi2Component fmi2Instantiate(fmi2String name, fmi2Type type, fmi2String guid, fmi2String resources,
                                     const fmi2CallbackFunctions *callbacks, fmi2Boolean visible, fmi2Boolean logging) {
    (void)resources, (void)visible, (void)logging;
    em_fmu *fmu = calloc(1, sizeof *fmu);
    if (fmu == NULL) return NULL;
    if (callbacks != NULL) fmu->callbacks = *callbacks;
    if ((fmu->name = malloc(strlen(name) + 1)) != NULL) strcpy(fmu->name, name);
    fmu->unit = em_unit_create(&EM_FMU_MODEL, EM_FMU_OPTIONS);
    const int known = type == fmi2CoSimulation && guid != NULL && strcmp(guid, EM_FMU_GUID) == 0;
    if (known && fmu->unit != NULL && fmu->name != NULL) return fmu;
    em_say(fmu, fmi2Error, known ? "out of memory" : "this unit is for co-simulation, and its GUID is " EM_FMU_GUID);
    return fmi2FreeInstance(fmu), NULL;
}

EM_FMU fmi2Status fmi2SetupExperiment(fmi2Component c, fmi2Boolean has_tolerance, fmi2Real tolerance, fmi2Real start,
                                      fmi2Boolean has_end, fmi2Real end) {
    em_fmu *fmu = c;
    (void)has_end, (void)end;
    if (!isfinite(start) || (has_tolerance && !(tolerance > 0.0 && tolerance < 1.0)))
        return em_say(fmu, fmi2Error, "the start is not finite, or the tolerance not between 0 and 1");
    em_unit_begin(fmu->unit, start, has_tolerance ? tolerance : 0.0);
    return fmi2OK;
}

EM_FMU fmi2Status fmi2EnterInitializationMode(fmi2Component c) {
    (void)c;
    return fmi2OK;
}

EM_FMU fmi2Status fmi2ExitInitializationMode(fmi2Component c) {
    em_fmu *fmu = c;
    return em_answer(fmu, em_unit_enter(fmu->unit));
}

EM_FMU fmi2Status fmi2Terminate(fmi2Component c) {
    (void)c;
    return fmi2OK;
}

EM_FMU fmi2Status fmi2Reset(fmi2Component c) {
    em_unit_reset(((em_fmu *)c)->unit);
    return fmi2OK;
}

/* --- numbers --- */

EM_FMU fmi2Status fmi2GetReal(fmi2Component c, const fmi2ValueReference vr[], size_t count, fmi2Real value[]) {
    em_fmu *fmu = c;
    return em_answer(fmu, em_unit_read(fmu->unit, vr, count, value));
}

EM_FMU fmi2Status fmi2SetReal(fmi2Component c, const fmi2ValueReference vr[], size_t count, const fmi2Real value[]) {
    em_fmu *fmu = c;
    for (size_t k = 0; k < count; ++k)
        if (em_unit_set(fmu->unit, vr[k], value[k])) return em_answer(fmu, 1);
    return fmi2OK;
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

/* --- the state --- */

EM_FMU fmi2Status fmi2GetFMUstate(fmi2Component c, fmi2FMUstate *state) {
    em_fmu *fmu = c;
    if (*state == NULL) *state = calloc(1, em_unit_size(fmu->unit));
    if (*state == NULL) return em_say(fmu, fmi2Error, "out of memory");
    em_unit_save(fmu->unit, *state);
    return fmi2OK;
}

EM_FMU fmi2Status fmi2SetFMUstate(fmi2Component c, fmi2FMUstate state) {
    em_fmu *fmu = c;
    return em_answer(fmu, em_unit_restore(fmu->unit, state));
}

EM_FMU fmi2Status fmi2FreeFMUstate(fmi2Component c, fmi2FMUstate *state) {
    (void)c;
    free(*state);
    *state = NULL;
    return fmi2OK;
}

EM_FMU fmi2Status fmi2SerializedFMUstateSize(fmi2Component c, fmi2FMUstate state, size_t *size) {
    (void)state;
    *size = em_unit_size(((em_fmu *)c)->unit);
    return fmi2OK;
}

EM_FMU fmi2Status fmi2SerializeFMUstate(fmi2Component c, fmi2FMUstate state, fmi2Byte bytes[], size_t size) {
    em_fmu *fmu = c;
    if (size < em_unit_size(fmu->unit)) return em_say(fmu, fmi2Error, "a state is larger than that");
    memcpy(bytes, state, em_unit_size(fmu->unit));
    return fmi2OK;
}

EM_FMU fmi2Status fmi2DeSerializeFMUstate(fmi2Component c, const fmi2Byte bytes[], size_t size, fmi2FMUstate *state) {
    em_fmu *fmu = c;
    if (size != em_unit_size(fmu->unit)) return em_say(fmu, fmi2Error, "these bytes are no state of this unit");
    if (*state == NULL) *state = malloc(size);
    if (*state == NULL) return em_say(fmu, fmi2Error, "out of memory");
    memcpy(*state, bytes, size);
    return fmi2OK;
}

/* --- steps --- */

EM_FMU fmi2Status fmi2DoStep(fmi2Component c, fmi2Real t, fmi2Real h, fmi2Boolean no_state_before) {
    em_fmu *fmu = c;
    (void)no_state_before;
    return em_unit_advance(fmu->unit, t + h) ? em_say(fmu, fmi2Discard, fmu->unit->words) : fmi2OK;
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
