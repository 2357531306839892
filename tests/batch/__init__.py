"""Many runs as one call: ensembles, lanes, processes, sweeps and their stores."""
