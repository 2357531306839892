"""Reasons for short steps, in words."""

_MANY_STEPS = 1000  # below, nobody waits for them


def stiffness(held: int, steps: int, iterates: bool) -> str:
    """Say that a scene is stiff, and what to do, where something else than their error kept most of many steps short.

    Parameters
    ----------
    held
        Steps that stability kept short, or the convergence of an iteration.
    iterates
        Whether the method finds its steps by iteration, which bears less than others.
    """
    if steps < _MANY_STEPS or 2 * held <= steps:
        return ""
    return (
        f" The scene is stiff: about {held} of {steps} steps were kept short by "
        f"{'an iteration that converges slowly' if iterates else 'stability'}, not by their error. Use "
        f"{'dop853, or ' if iterates else ''}a stiff method, radau9 or radau5."
    )
