"""Reference motions, by equations and methods that are independent of the generated code."""
