"""Outputs of contacts and frictions, for contact_conditions.py."""

from dataclasses import replace

from sympy import Expr

from ...codegen.model import Contact, Model, t


def with_contact_outputs(model: Model) -> Model:
    """Return the model with outputs of its contacts and frictions, if it has any.

    NAME_gap and its acceleration NAME_opens; NAME_slip, for a cone also NAME_aside; NAME_limit, NAME_sticks (at rest).
    """
    outputs: dict[str, Expr] = {}
    for name, entry in model.contacts:
        if isinstance(entry, Contact):
            outputs |= {f"{name}_gap": entry.gap, f"{name}_opens": entry.gap.diff(t, 2)}
        else:
            outputs |= dict(zip((f"{name}_slip", f"{name}_aside"), entry.slips, strict=False))
            outputs |= {f"{name}_limit": entry.limit, f"{name}_sticks": entry.sticking}
    return replace(model, outputs=(*model.outputs, *outputs.items())) if outputs else model
