/* em_no_fmi3.h: functions of FMI 3.0 that this unit has no use for: binary numbers, clocks, dependencies, adjoints. */

EM_FMU fmi3Status fmi3GetBinary(fmi3Instance c, const fmi3ValueReference vr[], size_t count, size_t sizes[],
                                fmi3Binary value[], size_t values) {
    (void)vr, (void)sizes, (void)value, (void)values;
    return em_none(c, count, "all numbers of this unit are Float64");
}

EM_FMU fmi3Status fmi3SetBinary(fmi3Instance c, const fmi3ValueReference vr[], size_t count, const size_t sizes[],
                                const fmi3Binary value[], size_t values) {
    (void)vr, (void)sizes, (void)value, (void)values;
    return em_none(c, count, "all numbers of this unit are Float64");
}

#define EM_NO_CLOCK "this unit has no clocks"

EM_FMU fmi3Status fmi3GetClock(fmi3Instance c, const fmi3ValueReference vr[], size_t count, fmi3Clock value[]) {
    return (void)vr, (void)value, em_none(c, count, EM_NO_CLOCK);
}

EM_FMU fmi3Status fmi3SetClock(fmi3Instance c, const fmi3ValueReference vr[], size_t count, const fmi3Clock value[]) {
    return (void)vr, (void)value, em_none(c, count, EM_NO_CLOCK);
}

EM_FMU fmi3Status fmi3GetIntervalDecimal(fmi3Instance c, const fmi3ValueReference vr[], size_t count,
                                         fmi3Float64 intervals[], fmi3IntervalQualifier qualifiers[]) {
    return (void)vr, (void)intervals, (void)qualifiers, em_none(c, count, EM_NO_CLOCK);
}

EM_FMU fmi3Status fmi3GetIntervalFraction(fmi3Instance c, const fmi3ValueReference vr[], size_t count,
                                          fmi3UInt64 counters[], fmi3UInt64 resolutions[],
                                          fmi3IntervalQualifier qualifiers[]) {
    return (void)vr, (void)counters, (void)resolutions, (void)qualifiers, em_none(c, count, EM_NO_CLOCK);
}

EM_FMU fmi3Status fmi3GetShiftDecimal(fmi3Instance c, const fmi3ValueReference vr[], size_t count, fmi3Float64 shifts[]) {
    return (void)vr, (void)shifts, em_none(c, count, EM_NO_CLOCK);
}

EM_FMU fmi3Status fmi3GetShiftFraction(fmi3Instance c, const fmi3ValueReference vr[], size_t count, fmi3UInt64 counters[],
                                       fmi3UInt64 resolutions[]) {
    return (void)vr, (void)counters, (void)resolutions, em_none(c, count, EM_NO_CLOCK);
}

EM_FMU fmi3Status fmi3SetIntervalDecimal(fmi3Instance c, const fmi3ValueReference vr[], size_t count,
                                         const fmi3Float64 intervals[]) {
    return (void)vr, (void)intervals, em_none(c, count, EM_NO_CLOCK);
}

EM_FMU fmi3Status fmi3SetIntervalFraction(fmi3Instance c, const fmi3ValueReference vr[], size_t count,
                                          const fmi3UInt64 counters[], const fmi3UInt64 resolutions[]) {
    return (void)vr, (void)counters, (void)resolutions, em_none(c, count, EM_NO_CLOCK);
}

EM_FMU fmi3Status fmi3SetShiftDecimal(fmi3Instance c, const fmi3ValueReference vr[], size_t count,
                                      const fmi3Float64 shifts[]) {
    return (void)vr, (void)shifts, em_none(c, count, EM_NO_CLOCK);
}

EM_FMU fmi3Status fmi3SetShiftFraction(fmi3Instance c, const fmi3ValueReference vr[], size_t count,
                                       const fmi3UInt64 counters[], const fmi3UInt64 resolutions[]) {
    return (void)vr, (void)counters, (void)resolutions, em_none(c, count, EM_NO_CLOCK);
}

EM_FMU fmi3Status fmi3ActivateModelPartition(fmi3Instance c, fmi3ValueReference vr, fmi3Float64 t) {
    return (void)vr, (void)t, em_none(c, 1, EM_NO_CLOCK);
}

EM_FMU fmi3Status fmi3GetNumberOfVariableDependencies(fmi3Instance c, fmi3ValueReference vr, size_t *count) {
    return (void)vr, (void)count, em_none(c, 1, "this unit does not say which numbers depend on which");
}

EM_FMU fmi3Status fmi3GetVariableDependencies(fmi3Instance c, fmi3ValueReference vr, size_t of[],
                                              fmi3ValueReference independents[], size_t at[],
                                              fmi3DependencyKind kinds[], size_t count) {
    (void)vr, (void)of, (void)independents, (void)at, (void)kinds, (void)count;
    return em_none(c, 1, "this unit does not say which numbers depend on which");
}

EM_FMU fmi3Status fmi3GetAdjointDerivative(fmi3Instance c, const fmi3ValueReference unknown[], size_t unknowns,
                                           const fmi3ValueReference known[], size_t count, const fmi3Float64 seed[],
                                           size_t seeds, fmi3Float64 sensitivity[], size_t sensitivities) {
    (void)unknown, (void)unknowns, (void)known, (void)count, (void)seed, (void)seeds, (void)sensitivity;
    return em_none(c, sensitivities + 1, "this unit has directional derivatives, but no adjoint ones");
}

EM_FMU fmi3Status fmi3GetOutputDerivatives(fmi3Instance c, const fmi3ValueReference vr[], size_t count,
                                           const fmi3Int32 orders[], fmi3Float64 value[], size_t values) {
    (void)vr, (void)orders, (void)value, (void)values;
    return em_none(c, count, "this unit gives no derivatives of its outputs");
}
