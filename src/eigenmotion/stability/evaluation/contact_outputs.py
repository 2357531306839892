"""Outputs of a model with contacts and frictions that `conditions` reads."""

from dataclasses import replace

from sympy import Expr

from ...codegen.model import Contact, Model, t


def watched(model: Model) -> Model:
    """Return a model with outputs of its contacts and frictions; one without any is the same.

    NAME_gap and NAME_opens, its acceleration; NAME_slip, of a cone NAME_aside too, NAME_limit, NAME_sticks (at rest).
    """
    outputs: dict[str, Expr] = {}
    for name, entry in model.contacts:
        if isinstance(entry, Contact):
            outputs |= {f"{name}_gap": entry.gap, f"{name}_opens": entry.gap.diff(t, 2)}
        else:
            outputs |= dict(zip((f"{name}_slip", f"{name}_aside"), entry.slips, strict=False))
            outputs |= {f"{name}_limit": entry.limit, f"{name}_sticks": entry.sticking}
    return replace(model, outputs=(*model.outputs, *outputs.items())) if outputs else model
