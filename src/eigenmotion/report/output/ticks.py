"""Labels of logarithmic axes."""

import math

from ...presentation.text import seconds


def powers_of_ten(low: float, high: float, most: float) -> list[float]:
    """Return powers of ten between two numbers, every one or every k-th, so that there are at most `most`.

    Examples
    --------
    >>> powers_of_ten(2e-3, 20.0, 3)
    [0.01, 1.0]
    """
    first, last = math.ceil(math.log10(low)), math.floor(math.log10(high))
    step = max(1, math.ceil((last - first + 1) / max(most, 1)))
    return [10.0**k for k in range(first, last + 1) if k % step == 0]


def heights_to_label(low: float, high: float) -> list[float]:
    """Return heights to label: powers of ten, and between them 2 and 5 times these on a short axis.

    Examples
    --------
    >>> heights_to_label(3.0, 60.0)
    [5.0, 10.0, 20.0, 50.0]
    """
    decades = math.log10(high / low)
    digits = (1, 2, 5) if decades < 2.2 else (1, 3) if decades < 3 else (1,)
    powers = range(math.floor(math.log10(low)), math.ceil(math.log10(high)))
    return [digit * 10.0**k for k in powers for digit in digits if low <= digit * 10.0**k <= high]


def height_in_words(height: float, is_time: bool) -> str:
    """Return a run time [s] or a count as text.

    Examples
    --------
    >>> height_in_words(2e-5, True), height_in_words(2e4, False), height_in_words(2e5, False)
    ('20 us', '20,000', '2e5')
    """
    if is_time:
        return seconds(height * (1 + 1e-12))
    return f"{height:,.0f}" if height < 1e5 else f"{height:.0e}".replace("e+0", "e")
