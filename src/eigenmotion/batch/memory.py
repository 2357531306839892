"""Check of the memory that the rows of an ensemble need, before it is allocated."""

import logging
import os

from ..arguments.sampled import Controlled
from ..arguments.tasks import EnsembleTask, Members
from ..codegen.model.normalise import ModelError

_LITTLE = 10**7  # [byte] no check below
_log = logging.getLogger("eigenmotion")


def check(common: EnsembleTask, members: Members) -> None:
    """Check that the rows of the runs fit into memory.

    Raises
    ------
    ModelError
        They need more memory than is available.
    """
    model = common.model
    columns = len(common.differentiated.names) if common.differentiated else 0
    width = model.n_state + 2 * model.n * columns
    numbers = len(common.t_eval) * width + 10 + model.n_events
    count = members.count
    needed = 8 * (numbers * count + _recorded(common, members))
    words = f"{model.name}: {count} runs with {len(common.t_eval)} rows of {width} numbers"
    _log.info("%s take %.3g GB", words, needed / 1e9)
    if short := shortage(needed):
        raise ModelError(
            f"{words} {short}. Give fewer rows in t_eval (none: the end state only), fewer runs at a time, or let "
            "`eigenmotion sweep` write them chunk by chunk."
        )


def _recorded(common: EnsembleTask, members: Members) -> float:
    """Return the count of numbers that record the values of controllers, and their times."""
    lists = [column for column in members.signals if isinstance(column, list)]
    periods = [one.sampled.period for each in lists for one in each if isinstance(one, Controlled)]
    return sum(2.0 * (common.t_end - common.t_start) / period for period in periods)


def shortage(needed: float) -> str:
    """Return a message if so many bytes exceed the available memory, else ""."""
    there = available() if needed > _LITTLE else None
    if there is None or needed <= there:
        return ""
    return f"take {needed / 1e9:.3g} GB, and {there / 1e9:.3g} GB are free"


def available() -> int | None:
    """Return the number of available bytes; None if the system does not report it."""
    try:
        with open("/proc/meminfo", encoding="ascii") as lines:  # noqa: PTH123, no path of a user's
            fields = {name: rest for name, _, rest in (line.partition(":") for line in lines)}
        return 1024 * int(fields["MemAvailable"].split()[0])
    except (OSError, KeyError, ValueError):
        pass
    try:
        return os.sysconf("SC_PHYS_PAGES") * os.sysconf("SC_PAGE_SIZE")
    except (AttributeError, OSError, ValueError):
        return None
