/* em_fmi2.h: types and enumerations of the Functional Mock-up Interface 2.0, as far as em_fmu2.h uses
 * them, after the standard (fmi-standard.org). */
#ifndef EM_FMI2_H
#define EM_FMI2_H

#include <stddef.h>

#ifdef _WIN32
#define EM_FMU __declspec(dllexport)
#else
#define EM_FMU __attribute__((visibility("default")))
#endif

/* Names of em_both.h. */
#define EM_FMI(name) fmi2##name
#define EM_FMI_STATE(before, after) fmi2##before##FMUstate##after
#define EM_FMI_DESERIALIZE fmi2DeSerializeFMUstate
#define EM_FMI_RATES fmi2GetDerivatives

typedef void *fmi2Component, *fmi2ComponentEnvironment, *fmi2FMUstate;
typedef unsigned int fmi2ValueReference;
typedef double fmi2Real;
typedef int fmi2Integer, fmi2Boolean;
typedef const char *fmi2String;
typedef char fmi2Byte;

typedef enum { fmi2OK, fmi2Warning, fmi2Discard, fmi2Error, fmi2Fatal, fmi2Pending } fmi2Status;
typedef enum { fmi2ModelExchange, fmi2CoSimulation } fmi2Type;
typedef enum { fmi2DoStepStatus, fmi2PendingStatus, fmi2LastSuccessfulTime, fmi2Terminated } fmi2StatusKind;

typedef struct {
    void (*logger)(fmi2ComponentEnvironment, fmi2String, fmi2Status, fmi2String, fmi2String, ...);
    void *(*allocateMemory)(size_t, size_t);
    void (*freeMemory)(void *);
    void (*stepFinished)(fmi2ComponentEnvironment, fmi2Status);
    fmi2ComponentEnvironment componentEnvironment;
} fmi2CallbackFunctions;

typedef struct {
    fmi2Boolean newDiscreteStatesNeeded, terminateSimulation, nominalsOfContinuousStatesChanged;
    fmi2Boolean valuesOfContinuousStatesChanged, nextEventTimeDefined;
    fmi2Real nextEventTime;
} fmi2EventInfo;

#endif
