"""Events in the state and in time: found, located, recorded."""
