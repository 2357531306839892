"""Compiled system: the functions of one compiled model at a state, with checked arguments."""

from collections.abc import Mapping
from typing import Any, TypeAlias

import numpy as np
from numpy.typing import ArrayLike

from ..arguments.named_values import Vector, is_named, overlay, vector
from ..arguments.options import SHARED_FROM_START, least_norm_of
from ..arguments.prescribed import with_prescribed
from ..arguments.signals import Inputs, bind, check_samples
from ..arguments.states import split_states, whole_x
from ..arguments.tables import with_tables
from ..codegen.model.normalise import ModelError, number, real
from ..presentation.notebook import table
from ..runtime import CompiledModel, EvaluationError, Prepared
from ..runtime.variations import motion_derivatives
from . import at_state
from .bodies import last_axis, many_positions, number_of_body, point_of
from .description import Description
from .eigenfactor_derivatives import EigenfactorGradient, eigenfactor_gradient, eta_sensitivity
from .projection import ConsistentState, Projection

Parameters: TypeAlias = Mapping[Any, Any] | ArrayLike | Prepared | None
Coordinates: TypeAlias = Mapping[Any, float] | ArrayLike | None


class CompiledSystem(Description):
    """The functions of a compiled model at one state, without runs. Base of `System`."""

    __slots__ = ("_defaults", "_inputs")

    def __init__(self, capsule: object) -> None:
        super().__init__(CompiledModel(capsule))
        self._defaults = self._compiled.prepare(self._compiled.parameter_defaults)
        self._inputs = bind({}, self._compiled.inputs, self._compiled.input_defaults)

    def __repr__(self) -> str:
        c = self._compiled
        return f"<{type(self).__name__} {c.name}: n={self.n}, m={c.m}, {c.n_state} states, {c.formulation}>"

    def _repr_html_(self) -> str:
        state = [f"{name}: y[{part.start}:{part.stop}]" for name, part in self.layout.items()]
        blocks = ["{" + ", ".join(self.coordinates[k] for k in block) + "}" for block in self.blocks]
        parameters = [f"{name} = {value:g}" for name, value in self.parameters.items()]
        return table(
            f"{self.name}: {self.n} coordinates, {self.m} constraint rows ({self.h} holonomic), {self.formulation}",
            {"state": state, "blocks of M": blocks, "parameters": parameters, "left out": self.left_out or "nothing"},
        )

    def __reduce__(self) -> tuple[Any, ...]:
        """Pickle the model and its options; it is built, or taken from the cache, where it is loaded."""
        self._compiled.__reduce__()  # raises if the model cannot be pickled
        return self._compiled.recipe, ()

    def prepare(self, parameters: Parameters = None) -> Prepared:
        """Return the constants of a parameter set, which can be passed as `parameters` instead of the values.

        Raises
        ------
        EvaluationError
            A constant block of M is not positive definite; or a value contradicts the assumptions of its symbol
            (positive, integer, ...); names both.
        """
        if parameters is None:
            return self._defaults
        if isinstance(parameters, Prepared):
            if parameters.model is not self._compiled:
                raise ModelError(f"parameters were prepared for {parameters.model.name}, another compiled model")
            return parameters
        named = with_tables(self._compiled, parameters)
        values = overlay(named, self._compiled.parameters, self._compiled.parameter_defaults, "parameter")
        return self._compiled.prepare(values)

    def state(
        self, x0: Coordinates = None, v0: Coordinates = None, t: float = 0.0, parameters: Parameters = None
    ) -> Vector:
        """Return y (n_state,) of the published equations at x0, v0.

        Raises
        ------
        EvaluationError
            M is not positive definite at x0; names the coordinate.
        """
        c, t = self.prepare(parameters), number(t, "t")
        return self._compiled.state(t, *self.begin(x0, v0, t, c), c)

    def start(
        self, x0: Coordinates = None, v0: Coordinates = None, t: float = 0.0, parameters: Parameters = None
    ) -> tuple[Vector, Vector]:
        """Return x (n,), v (n,): x0 and v0 over the model's `initial`.

        v0 may name quasi-velocities instead of rates. Quasi-velocities in `initial` apply at any x0. x0 may also name
        states, or have them behind the coordinates.
        """
        x, v = self.begin(x0, v0, t, parameters)
        return x[: self.n].copy(), v[: self.n].copy()

    def begin(
        self, x0: Coordinates = None, v0: Coordinates = None, t: float = 0.0, parameters: Parameters = None
    ) -> tuple[Vector, Vector]:
        """Return x, v (n + p,) of compiled functions, as `start`, with states in v and their integrals in x.

        Arrays are not copied.
        """
        return at_state.begin(self, self._compiled, self._defaults, x0, v0, t, parameters)

    def prepare_both(self, parameters: Parameters, inputs: Any) -> tuple[Prepared, Any]:
        """Return the constants of parameters and of those inputs that prescribe motions, and the other inputs."""
        if self._compiled.prescribed:
            parameters, inputs = with_prescribed(self._compiled, parameters, inputs)
        return self.prepare(parameters), inputs

    def bind(self, inputs: Mapping[Any, Any] | None = None) -> Inputs:
        """Return the inputs of a run: `inputs` over the defaults."""
        if inputs is None:
            return self._inputs
        bound = bind(inputs, self._compiled.inputs, self._compiled.input_defaults)
        check_samples(self._compiled, bound)
        return bound

    def rhs(
        self,
        t: float,
        y: ArrayLike,
        parameters: Parameters = None,
        inputs: Mapping[Any, Any] | ArrayLike | None = None,
        out: Vector | None = None,
    ) -> Vector:
        """Return dy/dt (n_state,), equations (20), (30), (35), (46): `fun` of `scipy.integrate.solve_ivp`.

        Parameters
        ----------
        y
            (n_state,) any stride; never written.
        inputs
            By name, or an array in the order of `System.inputs`.
        out
            The array to write to, which is returned.

        Raises
        ------
        EvaluationError
            M is singular, constraint rows depend on each other, or eigenvalues of one block coincide; names which.
        """
        if inputs is None:
            c, u = self._defaults if parameters is None else self.prepare(parameters), None
        else:
            c, inputs = self.prepare_both(parameters, inputs)
            u = self.signals(inputs, t)
        try:
            return self._compiled.rhs(t, y, c, u, out)
        except (TypeError, ValueError, OverflowError) as error:  # check arguments only now: solvers call this in a loop
            self._place(t, y)
            raise _as_our_error(error) from error

    def signals(self, inputs: Mapping[Any, Any] | ArrayLike | None, t: float) -> Vector:
        """Return u (n_inputs,) at t, from a mapping over the defaults, or an array in the order of `System.inputs`."""
        if is_named(inputs) and any(isinstance(u, tuple | list) or callable(u) for _, u in inputs.items()):
            return self.bind(inputs).at(t)
        u = overlay(inputs, self._compiled.inputs, self._compiled.input_defaults, "input")
        self._compiled.check_inputs(u)
        return u

    def mass_matrix(self, x: ArrayLike, t: float = 0.0, parameters: Parameters = None) -> Vector:
        """Return M (n, n) [J s^2 / (u_i u_j)] of T2 = 1/2 v^T M v (4)."""
        return at_state.mass_matrix(self, self._compiled, self._defaults, x, t, parameters)

    def mass_matrix_gradient(self, x: ArrayLike, t: float = 0.0, parameters: Parameters = None) -> Vector:
        """Return dM (n, n, n), [k, i, j] = dM_ij / dx_k."""
        n = self.n
        return self._compiled.mass_matrix_gradient(number(t, "t"), self._x(x), self.prepare(parameters))[:n, :n, :n]

    def eigenfactor_gradient(self, x: ArrayLike, t: float = 0.0, parameters: Parameters = None) -> EigenfactorGradient:
        """Return C, s of M(x) and their derivatives with respect to the coordinates, as in (24).

        Raises
        ------
        EvaluationError
            Eigenvalues of one block coincide: C has no derivative there.
        """
        prepared, c, t, x, n = self.prepare(parameters), self._compiled, number(t, "t"), self._x(x), self.n
        (C,), (s,) = c.eigenfactor_rows(np.array([t]), x[None], prepared)
        gradient = c.factored_gradient(t, x, prepared)[:n, :n, :n]
        return eigenfactor_gradient(gradient, C[:n, :n], s[:n], self.scales, self.blocks)

    def eta_sensitivity(self, x: ArrayLike, v: ArrayLike, t: float = 0.0, parameters: Parameters = None) -> Vector:
        """Return J = d eta / dx at fixed xdot, (n, n) (23)."""
        x, v = self.start(x, v, t, parameters)
        gradient = self.eigenfactor_gradient(x, t, parameters)
        eta = gradient.s * (gradient.C @ (v / self.scales))
        return eta_sensitivity(gradient, eta)

    def pfaffian(self, x: ArrayLike, t: float = 0.0, parameters: Parameters = None) -> tuple[Vector, Vector]:
        """Return A (m, n), b (m,) of A v + b = 0 (8); the h holonomic rows come first."""
        A, b = self._compiled.pfaffian(number(t, "t"), self._x(x), self.prepare(parameters))
        return A[:, : self.n], b

    def pose(self, body: Any, x: Coordinates, t: float = 0.0, parameters: Parameters = None) -> tuple[Vector, Vector]:
        """Return R (3, 3) and p (3,) [m] of a body: a point y of its frame is at p + R y in the frame of the ground.

        Parameters
        ----------
        body
            Its name, one of `bodies`.
        x
            (n,), or positions (n, k): then R is (3, 3, k) and p (3, k).
        t
            Not used: places depend on time by x alone.

        Raises
        ------
        ModelError
            There is no such body; names those that there are.
        """
        place, rows, many = self._of_body(body, x, t)
        R, p = self._compiled.pose_rows(place, rows, self.prepare(parameters))
        return last_axis(R, many), last_axis(p, many)

    def jacobian_of(
        self, body: Any, point: ArrayLike, x: Coordinates, t: float = 0.0, parameters: Parameters = None
    ) -> Vector:
        """Return J (6, n): J @ v is the velocity of a point of a body [m / s], then its angular velocity [rad / s].

        Both are in the axes of the ground. Columns belong to the coordinates, so that v is their rates, of modified
        Rodrigues parameters too. J[:3].T @ force + J[3:].T @ torque are the forces on the coordinates.

        Parameters
        ----------
        body
            Its name, one of `bodies`.
        point
            (3,) [m] in the body's frame.
        x
            (n,), or positions (n, k): then J is (6, n, k).
        t
            Not used: places depend on time by x alone.

        Raises
        ------
        ModelError
            There is no such body; names those that there are.
        """
        place, rows, many = self._of_body(body, x, t)
        J = self._compiled.body_jacobian_rows(place, point_of(point), rows, self.prepare(parameters))
        return last_axis(J, many)

    def _of_body(self, body: Any, x: Coordinates, t: float) -> tuple[int, Vector, bool]:
        """Return the number of a body, positions (k, n), and whether x is an array of them."""
        number(t, "t")
        place, rows = number_of_body(self._compiled, body), many_positions(self._compiled, x)
        return (place, self._x(x)[None], False) if rows is None else (place, rows, True)

    def acceleration(
        self,
        x: ArrayLike,
        v: ArrayLike,
        t: float = 0.0,
        parameters: Parameters = None,
        inputs: Mapping[Any, Any] | ArrayLike | None = None,
        *,
        dependent_constraints: str = "auto",
    ) -> tuple[Vector, Vector]:
        """Return d2x/dt2 (n,) and multipliers (m,); the constraints push with -A^T lambda (7).

        Raises
        ------
        EvaluationError
            M is singular, or constraint rows depend on each other: at this state only, or anywhere with "refuse".
        """
        least_norm = least_norm_of(dependent_constraints)
        return at_state.acceleration(self, self._compiled, self._defaults, x, v, t, parameters, inputs, least_norm)

    def project_initial_state(
        self,
        x0: Coordinates = None,
        v0: Coordinates = None,
        t: float = 0.0,
        parameters: Parameters = None,
        *,
        inputs: Mapping[Any, Any] | None = None,
        dependent_constraints: str = "auto",
    ) -> ConsistentState:
        """Return the state x (n,), v (n,) nearest in the mass metric with phi(x, t) = 0 and A v + b = 0.

        The pair has the changes as attributes: `dx`, `dv` (n,), and `distance`, `velocity_distance` in the mass metric.
        `inputs` count if they prescribe motions.

        Raises
        ------
        EvaluationError
            Newton's method does not reach phi = 0 from x0, or constraint rows depend on each other; names the row.
        """
        (c, _), t = self.prepare_both(parameters, inputs), number(t, "t")
        x, v = self.begin(x0, v0, t, c)
        shares = self._compiled.shares(t, x, c, least_norm_of(dependent_constraints))
        return Projection(self._compiled, c, t, shares)(x, v).of_coordinates(self.n)

    def energy(self, x: ArrayLike, v: ArrayLike, t: float = 0.0, parameters: Parameters = None) -> float:
        """Return T + V [J]."""
        T2, T1, T0, V = at_state.energies(self, self._compiled, self._defaults, x, v, t, parameters)
        return T2 + T1 + T0 + V

    def jacobi_integral(self, x: ArrayLike, v: ArrayLike, t: float = 0.0, parameters: Parameters = None) -> float:
        """Return T2 - T0 + V [J], conserved if nothing depends on time and no force does work."""
        T2, _, T0, V = at_state.energies(self, self._compiled, self._defaults, x, v, t, parameters)
        return T2 - T0 + V

    def _place(self, t: float, y: ArrayLike) -> tuple[float, Vector]:
        """Return t and y (n_state,) as numbers. Infinity and NaN, which solvers try, are allowed."""
        return real(t, "t"), vector(y, "y")

    def _x(self, x: Coordinates) -> Vector:
        return whole_x(self._compiled, split_states(self._compiled, x)[0], "coordinate of x")

    def jacobian(
        self,
        t: float,
        y: ArrayLike,
        parameters: Any = None,
        inputs: Mapping[Any, Any] | ArrayLike | None = None,
    ) -> Vector:
        """Return d rhs / d y, (n_state, n_state), row i the derivatives of dy_i: `jac` of SciPy's implicit methods.

        Exact to rounding in every formulation; at a kink of the right-hand side, the derivative of one side. A model
        whose state has eta instead of xdot is compiled once more at the first call, and cached.

        Raises
        ------
        EvaluationError
            As `rhs`.
        BuildError
            There is no compiler for that, or the compilation failed.
        ModelError
            The state has eta, and the module was not made by `build`, so its sources are unknown.
        """
        c = self.compiled
        if c.formulation in ("eigenfactor", "cholesky") and c.load_part is None and not c.differentiates:
            raise ModelError(f"{c.name}: the Jacobian of formulation {c.formulation!r} is compiled from its sources, "
                             "which only systems of eigenmotion.build know; or build with 'lagrange'")  # fmt: skip
        t, y = real(t, "t"), vector(y, "y")
        try:
            prepared, inputs = self.prepare_both(parameters, inputs)
            return c.jacobian(t, y, prepared, self.signals(inputs, t))
        except (TypeError, ValueError, OverflowError) as error:
            raise _as_our_error(error) from error

    def rhs_parameter_jacobian(
        self,
        t: float,
        y: ArrayLike,
        parameters: Any = None,
        inputs: Mapping[Any, Any] | ArrayLike | None = None,
    ) -> Vector:
        """Return d rhs / d parameters, (n_state, n_parameters), exact: to integrate sensitivities with SciPy.

        Raises
        ------
        ModelError
            The formulation is "eigenfactor" or "cholesky": its state has eta instead of xdot.
        EvaluationError
            As `rhs`.
        """
        c, n = self.compiled, self.compiled.n
        if c.formulation in ("eigenfactor", "cholesky"):
            raise ModelError(f"{c.name}: formulation {c.formulation!r} carries eta, which depends on parameters, too; "
                             "build with 'lagrange' or 'inverse', or ask simulate for sensitivities")  # fmt: skip
        t, y = real(t, "t"), vector(y, "y")
        if y.shape != (2 * n,):
            raise ModelError(f"y has shape {y.shape}, but this model needs {(2 * n,)}")
        prepared, inputs = self.prepare_both(parameters, inputs)
        _, _, da, _ = motion_derivatives(c, t, y[:n], y[n:], prepared, self.signals(inputs, t), SHARED_FROM_START)
        first = 2 * n + c.n_inputs
        return np.vstack([np.zeros((n, len(c.parameters))), da[:, first : first + len(c.parameters)]])


def _as_our_error(error: Exception) -> Exception:
    """Return an exception of a compiled function as an EvaluationError or ModelError."""
    return error if isinstance(error, EvaluationError | ModelError) else ModelError(str(error))
