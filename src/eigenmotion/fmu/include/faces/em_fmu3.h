/* em_fmu3.h: the functions of FMI 3.0, for co-simulation and model exchange; em_both.h has those that are as in 2.0.
 *
 * All numbers are of type Float64; there are no arrays, clocks or structural parameters. */
#include "em_face.h"
#include "em_fmi3.h"

static int em_say(const em_fmu *fmu, int status, const char *words) {
    const fmi3LogMessageCallback log = (fmi3LogMessageCallback)fmu->logger;
    if (log != NULL) log(fmu->environment, (fmi3Status)status, "logStatusError", words);
    return status;
}

#include "em_both.h"

EM_FMU const char *fmi3GetVersion(void) { return "3.0"; }

EM_FMU fmi3Instance fmi3InstantiateCoSimulation(fmi3String name, fmi3String token, fmi3String resources, fmi3Boolean visible,
                                                fmi3Boolean logging, fmi3Boolean event_mode, fmi3Boolean early_return,
                                                const fmi3ValueReference intermediate[], size_t count,
                                                fmi3InstanceEnvironment environment, fmi3LogMessageCallback logger,
                                                fmi3IntermediateUpdateCallback update) {
    (void)resources, (void)visible, (void)logging, (void)event_mode, (void)early_return;
    (void)intermediate, (void)count, (void)update; /* this unit has no event mode, and calls nobody during a step */
    return em_face_create(name, token, 1, (void (*)(void))logger, environment);
}

EM_FMU fmi3Instance fmi3InstantiateModelExchange(fmi3String name, fmi3String token, fmi3String resources, fmi3Boolean visible,
                                                 fmi3Boolean logging, fmi3InstanceEnvironment environment,
                                                 fmi3LogMessageCallback logger) {
    (void)resources, (void)visible, (void)logging;
    return em_face_flow(em_face_create(name, token, EM_FMU_FLOWS, (void (*)(void))logger, environment));
}

EM_FMU fmi3Instance fmi3InstantiateScheduledExecution(fmi3String name, fmi3String token, fmi3String resources,
                                                      fmi3Boolean visible, fmi3Boolean logging,
                                                      fmi3InstanceEnvironment environment, fmi3LogMessageCallback logger,
                                                      fmi3ClockUpdateCallback update, fmi3LockPreemptionCallback lock,
                                                      fmi3UnlockPreemptionCallback unlock) {
    (void)name, (void)token, (void)resources, (void)visible, (void)logging, (void)update, (void)lock, (void)unlock;
    if (logger != NULL) logger(environment, fmi3Error, "logStatusError", "this unit has no scheduled execution");
    return NULL;
}

EM_FMU fmi3Status fmi3EnterInitializationMode(fmi3Instance c, fmi3Boolean has_tolerance, fmi3Float64 tolerance,
                                              fmi3Float64 start, fmi3Boolean has_end, fmi3Float64 end) {
    (void)has_end, (void)end;
    return em_face_begin(c, has_tolerance, tolerance, start);
}

EM_NOTHING_TO_DO(EnterStepMode)
EM_NOTHING_TO_DO(EvaluateDiscreteStates)
EM_NOTHING_TO_DO(EnterConfigurationMode)
EM_NOTHING_TO_DO(ExitConfigurationMode)

/* --- numbers --- */

EM_FMU fmi3Status fmi3GetFloat64(fmi3Instance c, const fmi3ValueReference vr[], size_t count, fmi3Float64 value[],
                                 size_t values) {
    return count == values ? em_face_get(c, vr, count, value) : em_none(c, 1, "every number of this unit has one value");
}

EM_FMU fmi3Status fmi3SetFloat64(fmi3Instance c, const fmi3ValueReference vr[], size_t count, const fmi3Float64 value[],
                                 size_t values) {
    return count == values ? em_face_set(c, vr, count, value) : em_none(c, 1, "every number of this unit has one value");
}

#define EM_OTHERS(name, type)                                                                                         \
    EM_FMU fmi3Status fmi3Get##name(fmi3Instance c, const fmi3ValueReference vr[], size_t count, type value[],        \
                                    size_t values) {                                                                  \
        (void)vr, (void)value, (void)values;                                                                          \
        return em_none(c, count, "all numbers of this unit are Float64");                                             \
    }                                                                                                                 \
    EM_FMU fmi3Status fmi3Set##name(fmi3Instance c, const fmi3ValueReference vr[], size_t count, const type value[],  \
                                    size_t values) {                                                                  \
        (void)vr, (void)value, (void)values;                                                                          \
        return em_none(c, count, "all numbers of this unit are Float64");                                             \
    }

EM_OTHERS(Float32, fmi3Float32)
EM_OTHERS(Int8, fmi3Int8)
EM_OTHERS(UInt8, fmi3UInt8)
EM_OTHERS(Int16, fmi3Int16)
EM_OTHERS(UInt16, fmi3UInt16)
EM_OTHERS(Int32, fmi3Int32)
EM_OTHERS(UInt32, fmi3UInt32)
EM_OTHERS(Int64, fmi3Int64)
EM_OTHERS(UInt64, fmi3UInt64)
EM_OTHERS(Boolean, fmi3Boolean)
EM_OTHERS(String, fmi3String)

EM_FMU fmi3Status fmi3GetDirectionalDerivative(fmi3Instance c, const fmi3ValueReference unknown[], size_t unknowns,
                                               const fmi3ValueReference known[], size_t count, const fmi3Float64 seed[],
                                               size_t seeds, fmi3Float64 sensitivity[], size_t sensitivities) {
    em_fmu *fmu = c;
    if (seeds != count || sensitivities != unknowns) return em_none(c, 1, "every number of this unit has one value");
    return em_answer(fmu, em_unit_along(fmu->unit, unknown, unknowns, known, count, seed, sensitivity));
}

/* --- steps --- */

/* After fmi3Discard the unit stands at the time that it reached. */
EM_FMU fmi3Status fmi3DoStep(fmi3Instance c, fmi3Float64 t, fmi3Float64 h, fmi3Boolean no_state_before, fmi3Boolean *event,
                             fmi3Boolean *terminate, fmi3Boolean *early, fmi3Float64 *reached) {
    em_fmu *fmu = c;
    (void)no_state_before;
    *event = *terminate = *early = false;
    const int status = em_try(fmu, em_unit_advance(fmu->unit, t + h));
    *reached = em_unit_time(fmu->unit);
    return status;
}

/* --- model exchange --- */

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

EM_FMU fmi3Status fmi3GetNumberOfContinuousStates(fmi3Instance c, size_t *count) {
    *count = 2 * (size_t)((em_fmu *)c)->unit->model->n;
    return fmi3OK;
}

EM_FMU fmi3Status fmi3GetNumberOfEventIndicators(fmi3Instance c, size_t *count) {
    *count = (size_t)((em_fmu *)c)->unit->model->n_events;
    return fmi3OK;
}
