"""Export of a model as external functions of CasADi."""
