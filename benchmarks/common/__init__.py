"""Functions shared by several benchmarks."""
