"""System: a compiled model with its functions, runs and analyses."""

from functools import partial
from importlib import import_module
from typing import Any

from ..analysis.identification.regressor import regressor
from ..analysis.inverse.force_derivatives import inverse_dynamics_derivatives
from ..analysis.inverse.inverse_dynamics import inverse_dynamics
from ..analysis.linear.linearize import linearize
from ..batch.stepper.open_steppers import steppers
from ..compiled.compiled_system import CompiledSystem
from ..simulation.simulate import simulate
from ..simulation.stepper import stepper


def _of_module(name: str) -> Any:
    return import_module(name).system


class System(CompiledSystem):
    """The functions of one compiled model. Immutable; threads may share it.

    In all methods, x0 and v0 are arrays (n,) or mappings coordinate -> value over the model's `initial`; v0 may also
    map quasi-velocities. `parameters` is a mapping name -> value over the defaults, an array in the order of
    `System.parameters`, or a result of `prepare`. `inputs` is a mapping name -> number, (times, values) or Signal. An
    unknown name raises ModelError.

    Parameters
    ----------
    capsule
        A PyCapsule "eigenmotion.em_model" of a generated module.
    module
        Name of the importable module whose `system` this is, by which it is pickled. `build` sets another way.

    Examples
    --------
    >>> import eigenmotion as em
    >>> from eigenmotion.models.pendulum import model
    >>> system = em.build(model)
    >>> system.coordinates, system.parameters
    (('theta',), {'m': 1.0, 'l': 1.0, 'g': 9.81})
    >>> system.rhs(0.0, system.state({"theta": 1.5})).round(6)
    array([ 0.      , -9.785426])
    """

    __slots__ = ()

    def __init__(self, capsule: object, module: str | None = None) -> None:
        super().__init__(capsule)
        if module:
            self._compiled.recipe = partial(_of_module, module)

    simulate = simulate  # functions as methods, with their options
    stepper = stepper
    steppers = steppers
    linearize = linearize
    inverse_dynamics = inverse_dynamics
    inverse_dynamics_derivatives = inverse_dynamics_derivatives
    regressor = regressor
