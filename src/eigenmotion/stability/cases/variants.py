"""Variants: formulations and options, the columns of the matrix."""

from dataclasses import dataclass, fields

from ...codegen.choices import FORMULATIONS, Choices


@dataclass(frozen=True, slots=True)
class Variant(Choices):
    """Options of the generated code and of a run."""

    stabilisation: str = "project"
    dependent_constraints: str = "refuse"

    @property
    def label(self) -> str:
        """The formulation, and the options that differ from the defaults."""
        defaults = {"bounded", "auto", "project", "refuse"}
        words = {"eigenfactor": "schur eigenfactor", "none": "not stabilised", "least_norm": "least norm"}
        chosen = (self.close_eigenvalues, self.schur, self.stabilisation, self.dependent_constraints)
        return ", ".join([self.formulation, *(words.get(c, c) for c in chosen if c not in defaults)])

    @property
    def build(self) -> dict[str, str]:
        """The options of `eigenmotion.build`."""
        return {option.name: getattr(self, option.name) for option in fields(Choices)}

    @property
    def run(self) -> dict[str, str]:
        """The options of `eigenmotion.simulate`."""
        return {"stabilisation": self.stabilisation, "dependent_constraints": self.dependent_constraints}


PLAIN = tuple(Variant(formulation) for formulation in FORMULATIONS)
EXTRAPOLATE = Variant("eigenfactor", close_eigenvalues="extrapolate")
UNSTABILISED = Variant("eigenfactor", stabilisation="none")
UNCONSTRAINED = (*PLAIN, EXTRAPOLATE, UNSTABILISED)
CONSTRAINED = (*UNCONSTRAINED, Variant("lagrange", stabilisation="none"))
SEVERAL_ROWS = (*CONSTRAINED, Variant("eigenfactor", schur="eigenfactor"))
CONTACTS = (*PLAIN, UNSTABILISED)
DEPENDENT_ROWS = (*SEVERAL_ROWS, *(Variant(f, dependent_constraints="least_norm") for f in ("eigenfactor", "lagrange")))
