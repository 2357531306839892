# Declarations of record.pyx for the other modules of the runtime.

cpdef dict record(t, y, t_events, y_events, stop, message, str method, tuple counts, sol=*, y_after_events=*, tuple modes=*)
cpdef tuple modes_of(model, segments)
