"""Independent oracles: they share no code with what they test and read nothing of a model but its raw fields."""

from .lagrange import Lagrange as Lagrange
from .state import State as State
from .state import initial_state as initial_state
from .state import parameters_of as parameters_of
from .trajectory import trajectory as trajectory
