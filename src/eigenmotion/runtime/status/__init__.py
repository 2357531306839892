"""Ends of calls and runs, in words."""
