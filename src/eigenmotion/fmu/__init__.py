"""Export of models as Functional Mock-up Units."""
