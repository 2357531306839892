"""Code-generation options of `build`: how the equations of a model are computed."""

from __future__ import annotations

from dataclasses import dataclass

from .model import ModelError

FORMULATIONS = ("eigenfactor", "cholesky", "lagrange", "inverse")
OF_TREES = ("articulated_body",)
"""Formulations of models whose masses are in trees of bodies."""
CARRY_V = ("lagrange", "inverse", *OF_TREES)
"""Formulations whose state is (x, xdot)."""
CLOSE_EIGENVALUES = ("bounded", "extrapolate")
SCHUR = ("auto", "factor", "eigenfactor")


@dataclass(frozen=True, slots=True)
class Choices:
    """Options that change the generated code; see section "Build" of the manual.

    Raises
    ------
    ModelError
        The value of an option is unknown.
    """

    formulation: str = "eigenfactor"
    close_eigenvalues: str = "bounded"
    schur: str = "auto"

    def __post_init__(self) -> None:
        _check("formulation", self.formulation, (*FORMULATIONS, *OF_TREES))
        _check("close_eigenvalues", self.close_eigenvalues, CLOSE_EIGENVALUES)
        _check("schur", self.schur, SCHUR)

    @property
    def eigenfactor(self) -> bool:
        """Whether the state contains C and s, as in the published system."""
        return self.formulation == "eigenfactor"

    @property
    def carries_v(self) -> bool:
        """Whether the state is (x, xdot)."""
        return self.formulation in CARRY_V

    @property
    def bounded(self) -> bool:
        """Whether the triangular root is used near coincident eigenvalues."""
        return self.eigenfactor and self.close_eigenvalues == "bounded"

    @property
    def extrapolate(self) -> bool:
        """Whether Omega is extrapolated near coincident eigenvalues (32), (53)."""
        return self.eigenfactor and self.close_eigenvalues == "extrapolate"


def _check(what: str, value: str, known: tuple[str, ...]) -> None:
    if value not in known:
        raise ModelError(f"{what} {value!r} is not known; choose one of {', '.join(known)}")


STANDARD = Choices()
