"""Message about stiffness."""

_MANY_STEPS = 1000  # shorter runs are quick anyway


def stiffness(bounded: int, steps: int, iterates: bool) -> str:
    """Return advice to use a stiff method, or "" if the error limited most steps or the run is short.

    Parameters
    ----------
    bounded
        Number of steps that were limited by stability, or by the convergence of an iteration.
    iterates
        Whether the method solves its steps by iteration, which limits them more than stability does.
    """
    if steps < _MANY_STEPS or 2 * bounded <= steps:
        return ""
    return (
        f" The scene is stiff: about {bounded} of {steps} steps were kept short by "
        f"{'an iteration that converges slowly' if iterates else 'stability'}, not by their error. Use "
        f"{'dop853, or ' if iterates else ''}a stiff method, radau9 or radau5."
    )
