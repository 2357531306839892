"""Motions that the cases should show: closed forms, and integration in extended precision."""
