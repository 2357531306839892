"""The same motion by equations and methods that share nothing with generated code."""
