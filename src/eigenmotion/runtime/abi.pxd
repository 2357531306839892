# Declarations of the ABI: eigenmotion.h and the two headers it includes.

cdef extern from "eigenmotion.h" nogil:
    const int EM_ABI
    const int EM_DENSE_COEFFICIENTS

    ctypedef enum em_status:
        EM_TERMINAL_EVENT
        EM_NON_FINITE_STATE
        EM_INTERRUPTED

    ctypedef struct em_fault:
        em_status status
        int first
        int second
        double size

    ctypedef struct em_slice:
        const char *name
        int start
        int length

    ctypedef struct em_shape:
        const char *kind
        int first
        int count
        int n_corners
        const float *corners

    ctypedef enum em_signal_kind:
        pass

    ctypedef struct em_signal:
        em_signal_kind kind
        size_t count
        const double *times
        const double *values

    ctypedef enum em_method:
        EM_DOP853
        EM_RA15
        EM_RK4
        EM_MIDPOINT
        EM_RADAU5
        EM_RADAU9

    ctypedef struct em_rows:
        size_t count
        size_t width
        double *t
        double *y

    ctypedef struct em_dense_step:
        double t
        double h

    ctypedef struct em_event_action:
        int keeps_apart
        int acts

    ctypedef struct em_switch:
        int event
        int holds
        int slides
        int over
        int row
        int idles
        int poisson
        int shift

    ctypedef struct em_pile:
        double t
        double count

    ctypedef enum em_dependent:
        EM_REFUSED
        EM_SHARED
        EM_SHARED_FROM_START

    ctypedef struct em_run:
        double t_start
        double t_end
        const double *y_start
        const double *prepared
        const em_signal *inputs
        em_method method
        int changes
        em_method other
        double rtol
        const double *atol
        double first_step
        double max_step
        long max_steps
        int stabilise
        int least_norm
        int dense
        const double *t_eval
        size_t n_t_eval
        const int *event_direction
        const int *event_terminal
        int (*poll)(void *) noexcept nogil
        void *poll_argument
        em_fault fault
        em_rows rows
        em_rows *events
        em_rows *after
        em_rows charts
        em_rows last
        em_rows segments
        em_rows methods
        int waits
        em_dense_step *dense_steps
        double *dense_table
        size_t n_dense
        long n_rhs
        long n_steps
        long n_rejected
        long n_bounded
        long n_jacobians
        long n_factors
        long n_stiff
        double t_reached
        const em_model *model

    ctypedef struct em_lane_group:
        int n_live

    ctypedef struct em_lanes:
        int width
        void (*run)(em_lane_group *) noexcept nogil

    ctypedef struct em_declared:
        int bits
        const char *words

    ctypedef struct em_table:
        int parameter
        int is_input
        const double *numbers

    ctypedef struct em_table_use:
        int table
        int axis
        int order
        int timed

    ctypedef struct em_body:
        const char *name

    ctypedef struct em_actuators:
        int count
        const int *coordinate
        const int *input
        const double *weight

    ctypedef struct em_inverse_check:
        double undriven
        double forbidden
        int equation
        int row

    ctypedef struct em_model:
        int abi
        const char *name
        const char *formulation
        const char *close_eigenvalues
        const char *schur
        int n
        int m
        int h
        int n_state
        int n_parameters
        int n_prepared
        int n_inputs
        int n_outputs
        int n_events
        int n_layout
        int n_left_out
        const char *const *coordinates
        const char *const *parameters
        const double *parameter_defaults
        const char *const *inputs
        const double *input_defaults
        const double *initial_x
        const double *initial_v
        const char *const *outputs
        const char *const *events
        const int *event_direction
        const int *event_terminal
        const em_slice *layout
        const char *const *left_out
        const int *block
        const double *scales
        const int *carried
        int conserves_energy
        int (*prepare)(const double *, double *, em_fault *) noexcept nogil
        int (*state)(double, const double *, const double *, const double *, double *, em_fault *) noexcept nogil
        int (*velocity)(double, const double *, const double *, double *, em_fault *) noexcept nogil
        int (*rhs)(double, const double *, const double *, const double *, double *, em_fault *) noexcept nogil
        void (*mass_matrix)(double, const double *, const double *, double *) noexcept nogil
        void (*mass_matrix_gradient)(double, const double *, const double *, double *) noexcept nogil
        void (*factored_gradient)(double, const double *, const double *, double *) noexcept nogil
        void (*pfaffian)(double, const double *, const double *, double *, double *) noexcept nogil
        void (*position)(double, const double *, const double *, double *, double *) noexcept nogil
        int (*acceleration)(double, const double *, const double *, const double *, const double *, int,
                            double *, double *, em_fault *) noexcept nogil
        int (*project)(double, double *, double *, const double *, int, em_fault *) noexcept nogil
        int (*redundant)(double, const double *, const double *, int *) noexcept nogil
        void (*energy)(double, const double *, const double *, const double *, double *) noexcept nogil
        int (*eigenfactors)(double, const double *, const double *, double *, double *, em_fault *) noexcept nogil
        int (*output)(double, const double *, const double *, const double *, const double *, int,
                      double *, em_fault *) noexcept nogil
        int (*jacobian)(double, const double *, const double *, const double *, double *, em_fault *) noexcept nogil
        int (*motion_jacobian)(double, const double *, const double *, const double *, int, double *,
                               em_fault *) noexcept nogil
        int (*simulate)(em_run *) noexcept nogil
        int (*interpolate)(const em_run *, size_t, double, double *) noexcept nogil
        void (*release)(em_run *) noexcept nogil
        int n_quasi
        const char *const *quasi_velocities
        const double *initial_y
        void (*quasi)(double, const double *, const double *, const double *, double *) noexcept nogil
        void (*event)(double, const double *, const double *, const double *, const double *, double *) noexcept nogil
        void (*factored_matrix)(double, const double *, const double *, double *) noexcept nogil
        const em_event_action *event_actions
        const char *const *rows
        int n_switches
        const em_switch *switches
        void (*levels)(double, const double *, const double *, const double *, const double *, double *) noexcept nogil
        const em_lanes *lanes
        void *(*enter)(em_run *, int *) noexcept nogil
        int n_shapes
        int dimension
        const em_shape *shapes
        void *(*open)(em_run *) noexcept nogil
        int (*advance)(void *, double, int) noexcept nogil
        double (*now)(const void *, double *, double *) noexcept nogil
        int (*publish)(const void *, double *, em_fault *) noexcept nogil
        size_t (*saved)() noexcept nogil
        void (*save)(const void *, void *) noexcept nogil
        void (*restore)(void *, const void *) noexcept nogil
        void (*close)(void *) noexcept nogil
        void (*draw)(double, const double *, const double *, const double *, double *) noexcept nogil
        int n_arguments
        int (*motion_derivatives)(double, const double *, const double *, const double *, const double *, int,
                                  double *, double *, double *, double *, em_fault *) noexcept nogil
        void (*constraint_partials)(double, const double *, const double *, const double *, double *) noexcept nogil
        void (*output_partials)(double, const double *, const double *, const double *, const double *,
                                const double *, const double *, double *) noexcept nogil
        void (*event_partials)(double, const double *, const double *, const double *, const double *,
                               double *) noexcept nogil
        void (*quasi_partials)(double, const double *, const double *, const double *, double *) noexcept nogil
        int (*motion_along)(double, const double *, const double *, const double *, const double *, int, int,
                            const double *, const double *, double *, double *, double *, em_fault *) noexcept nogil
        int (*tangent)(double, const double *, const double *, const double *, int, int, double *, const double *,
                       em_fault *) noexcept nogil
        int (*act_along)(double, double *, double *, double *, const double *, int, int *, em_pile *, int, double *,
                         const double *, em_fault *) noexcept nogil
        int n_time_events
        void (*time_events)(const double *, double *) noexcept nogil
        void (*time_event_partials)(const double *, double *) noexcept nogil
        void (*rate_jacobian)(double, const double *, const double *, const double *, double *) noexcept nogil
        const em_declared *declared
        int n_tables
        int n_table_uses
        const em_table *tables
        const em_table_use *table_uses
        void (*table_arguments)(double, const double *, const double *, const double *, const double *, double *) noexcept nogil
        int n_states
        int n_bodies
        const em_body *bodies
        void (*frames)(const double *, double *) noexcept nogil
        int n_rotations
        const int (*rotations)[3]
        void (*required_forces)(double, const double *, const double *, const double *, const double *, const double *,
                                double *, double *) noexcept nogil
        void (*input_columns)(double, const double *, const double *, const double *, const double *, const double *,
                              double *) noexcept nogil
        const unsigned char *mixed_inputs
        void (*pushes)(double, const double *, const double *, const double *, const double *, double *) noexcept nogil
        int n_normals
        const unsigned char *normals
        int (*inverse_dynamics)(double, const double *, const double *, const double *, const double *, const double *,
                                const em_actuators *, double *, double *, double *, em_inverse_check *,
                                em_fault *) noexcept nogil
        void (*equation_partials)(double, const double *, const double *, const double *, const double *, const double *,
                                  const double *, double *) noexcept nogil
        void (*observe)(double, const double *, const double *, const double *, const double *, const double *,
                        const double *, double *) noexcept nogil
