"""Units as words behind names: of axes, sliders and columns. A model without units has none anywhere."""

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


def time_unit(units: Units) -> str:
    """Return the unit of the time: seconds, unless the units of the model have another; "" for a model without units.

    Examples
    --------
    >>> time_unit({"theta": "rad"}), time_unit({"time": "ms"}), time_unit(None)
    ('s', 'ms', '')
    """
    return units.get("time", "s") if units else ""


def with_unit(text: str, unit: str) -> str:
    """Return a text with its unit in brackets.

    Examples
    --------
    >>> with_unit("theta", "rad"), with_unit("theta", "")
    ('theta [rad]', 'theta')
    """
    return f"{text} [{unit}]" if unit else text
