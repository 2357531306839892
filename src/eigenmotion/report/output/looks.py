"""Looks of curves: a colour for each kind, a line style for each method, on light and on dark ground."""

from dataclasses import dataclass

from ...presentation.figures import BLACK, FORMULATIONS, ORANGE, SKY


@dataclass(frozen=True, slots=True)
class Ink:
    """A colour on white, and the one of its kind on a dark ground."""

    light: str
    dark: str


_OTHER = Ink("#666666", "#a0a0a0")
INKS = {
    "eigenfactor": Ink(FORMULATIONS["eigenfactor"], "#5db1ec"),
    "cholesky": Ink(FORMULATIONS["cholesky"], "#ff8a3d"),
    "lagrange": Ink(FORMULATIONS["lagrange"], "#2fcf9f"),
    "inverse": Ink(FORMULATIONS["inverse"], "#e29bc4"),
    "articulated_body": Ink(BLACK, "#f0f0f0"),  # of trees of bodies, which other packages do not get
    "implicit": Ink("#882255", "#d9699b"),
    "heyoka.py": Ink(BLACK, "#f0f0f0"),
    "CVODES": Ink(ORANGE, "#f0b030"),
    "SciPy": Ink(SKY, "#8ecff5"),
    "": _OTHER,
}
"""Kind of a curve -> its colours; that of "" for kinds without one."""

_DASHES = {
    "dop853": (), "ra15": (5, 2), "dopri5": (2, 2), "rk34": (7, 2, 1, 2), "radau5": (5, 2), "radau9": (),
    "Taylor": (), "BDF": (), "Adams": (2, 2), "DOP853": (), "LSODA": (5, 2), "Radau": (2, 2),
}  # fmt: skip


def ink(kind: str) -> Ink:
    """Return the colours of a kind.

    Examples
    --------
    >>> ink("eigenfactor").light
    '#0072B2'
    """
    return INKS.get(kind, _OTHER)


def dashes(method: str) -> tuple[int, ...]:
    """Return lengths of dashes and gaps, in widths of the line; () for a solid line.

    Examples
    --------
    >>> dashes("dop853"), dashes("ra15")
    ((), (5, 2))
    """
    return _DASHES.get(method, ())
