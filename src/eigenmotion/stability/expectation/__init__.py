"""Expected motions of the cases: closed forms, and integration in extended precision."""
