# Declarations of em_forward_kinematics.h: places of bodies.

from .abi cimport em_model


cdef extern from "kinematics/em_forward_kinematics.h" nogil:
    const int EM_FRAME
    void em_body_pose(const em_model *, int, const double *, const double *, double *, double *)
    void em_body_jacobian(const em_model *, int, const double *, const double *, const double *, int, double *)
