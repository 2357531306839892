"""Starts of runs: consistent ones, and those of runs that go on."""
