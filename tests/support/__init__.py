"""Parts that tests of several rooms share: models, compiled systems, C written by hand."""
