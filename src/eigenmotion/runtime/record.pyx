# cython: language_level=3
"""Fields of a Solution (results/solution.py), for runs by any method."""

from .status.stop_reasons import StopReason

COUNTS = ("nfev", "nsteps", "nrejected", "n_bounded", "n_stiff", "njev", "nlu")
"""The counts of a `Solution`."""
cdef object _FINISHED = StopReason.FINISHED, _TERMINAL_EVENT = StopReason.TERMINAL_EVENT


cpdef dict record(t, y, t_events, y_events, stop, message, str method, tuple counts, sol=None,
                  y_after_events=None, tuple modes=()):
    """The fields of a Solution as a dict, without empty ones; counts in the order of COUNTS."""
    nfev, nsteps, nrejected, n_bounded, n_stiff, njev, nlu = counts
    cdef int status = 0 if stop is _FINISHED else 1 if stop is _TERMINAL_EVENT else -1
    cdef dict fields = {
        "t": t, "y": y, "nfev": nfev, "status": status, "message": message, "success": status >= 0, "nsteps": nsteps,
        "nrejected": nrejected, "stop": stop, "method": method,
    }
    if njev != 0:
        fields["njev"] = njev
    if nlu != 0:
        fields["nlu"] = nlu
    if n_bounded != 0:
        fields["n_bounded"] = n_bounded
    if n_stiff != 0:
        fields["n_stiff"] = n_stiff
    if sol is not None:
        fields["sol"] = sol
    if t_events is not None:
        fields["t_events"], fields["y_events"] = t_events, y_events
        fields["y_after_events"] = y_events if y_after_events is None else y_after_events
    if modes:
        fields["modes"] = modes
    return fields


cdef dict _mode_of(model, parameters):
    """Parameter name -> value of a mode: which contacts hold, and which frictions stick or slide.

    An idle contact counts as holding: others keep it at rest.
    """
    cdef dict mode = {}
    for _, holds, slides, _, idles, *_ in model.switches:
        idle = parameters[idles] > 0.0
        mode[model.parameters[holds]] = 1.0 if idle else parameters[holds]
        if slides >= 0:
            mode[model.parameters[slides]] = 0.0 if idle else parameters[slides]
    return mode


cpdef tuple modes_of(model, segments):
    """For each of `Run.segments` its start time and its mode as a dict; only changes of the mode are listed."""
    if not segments:
        return ()
    modes = [(t, _mode_of(model, parameters)) for _, t, parameters in segments]
    last = [mode for k, mode in enumerate(modes) if k + 1 == len(modes) or mode[0] != modes[k + 1][0]]
    return tuple([mode for k, mode in enumerate(last) if k == 0 or mode[1] != last[k - 1][1]])
