"""`System.stepper` and `steppers`: runs that the caller advances, one or many."""
