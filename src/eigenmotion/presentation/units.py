"""Units as words behind names: of axes, sliders and columns. A model without units has none anywhere."""

import re
from collections.abc import Mapping

Units = Mapping[str, str] | None
"""Name -> unit, of a model (`codegen.model.statement.units`)"""


def unit_of(units: Units, name: str, order: int = 0) -> str:
    """Return the unit of a name, or of its derivative of some order with respect to time; "" if there is none.

    Examples
    --------
    >>> unit_of({"theta": "rad"}, "theta"), unit_of({"theta": "rad", "time": "ms"}, "theta", 2), unit_of(None, "theta")
    ('rad', 'rad/ms^2', '')
    """
    unit = (units or {}).get(name, "")
    if not unit or not order:
        return unit
    return f"{unit}/{time_unit(units)}" + (f"^{order}" if order > 1 else "")


def unit_of_marked(units: Units, name: str) -> str:
    """Return the unit of a name with a prime for each derivative, and "(0)" behind a value at the start.

    Examples
    --------
    >>> unit_of_marked({"theta": "rad"}, "theta'(0)"), unit_of_marked({"theta": "rad"}, "m")
    ('rad/s', '')
    """
    moving = name.removesuffix("(0)")
    plain = moving.rstrip("'")
    return unit_of(units, plain, len(moving) - len(plain))


def force_unit(units: Units, name: str) -> str:
    """Return the unit of the force on a coordinate, energy over its unit; "" if the model does not say both.

    Examples
    --------
    >>> force_unit({"x": "mm", "energy": "mJ"}, "x"), force_unit({"x": "mm"}, "x")
    ('mJ/mm', '')
    """
    energy, unit = (unit_of(units, one) for one in ("energy", name))
    return f"{energy}/{unit}" if energy and unit else ""


def power_unit(units: Units) -> str:
    """Return the unit of power, energy over time; "" if the model does not say that of energy.

    Examples
    --------
    >>> power_unit({"energy": "mJ"}), power_unit({"x": "mm"})
    ('mJ/s', '')
    """
    energy = unit_of(units, "energy")
    return f"{energy}/{time_unit(units)}" if energy else ""


def time_unit(units: Units) -> str:
    """Return the unit of the time: seconds, unless the units of the model have another; "" for a model without units.

    Examples
    --------
    >>> time_unit({"theta": "rad"}), time_unit({"time": "ms"}), time_unit(None)
    ('s', 'ms', '')
    """
    return units.get("time", "s") if units else ""


def with_unit(text: str, unit: str) -> str:
    """Return a text with its unit in brackets, as it was given: for files, and for the terminal.

    Examples
    --------
    >>> with_unit("theta", "rad"), with_unit("theta", "")
    ('theta [rad]', 'theta')
    """
    return f"{text} [{unit}]" if unit else text


_RAISED = str.maketrans("-0123456789", "⁻⁰¹²³⁴⁵⁶⁷⁸⁹")


def in_print(unit: str) -> str:
    """Return a unit as it is printed, with raised powers and points between factors; pages do the same.

    Examples
    --------
    >>> in_print("kg m^2/s^2"), in_print("N*m"), in_print("s^-1")
    ('kg·m²/s²', 'N·m', 's⁻¹')
    """
    raised = re.sub(r"(?:\^|\*\*)(-?\d+)", lambda power: power[1].translate(_RAISED), unit)
    return re.sub(r"(?<=\S) +(?=\S)", "·", raised).replace("*", "·")


def on_axis(text: str, unit: str) -> str:
    """Return a text with its unit in brackets, for pictures.

    Examples
    --------
    >>> on_axis("a", "m/s^2"), on_axis("a", "")
    ('a [m/s²]', 'a')
    """
    return with_unit(text, in_print(unit))
