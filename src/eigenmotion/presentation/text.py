"""Numbers as text."""


def number(value: float | None) -> str:
    """Return a number with three digits; a dash for None."""
    return "-" if value is None else f"{value:.3g}"


def seconds(value: float | None) -> str:
    """Return a time with a suitable unit."""
    if value is None:
        return "-"
    for unit, size in (("s", 1.0), ("ms", 1e-3), ("us", 1e-6)):
        if value >= size:
            return f"{value / size:.3g} {unit}"
    return f"{value / 1e-9:.3g} ns"
