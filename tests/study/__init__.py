"""Reports, the stability matrix, the paper's experiment, reference motions and the oracles."""
