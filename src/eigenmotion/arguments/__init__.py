"""Checks of users' arguments: names and arrays, inputs, options and methods of a run."""
