"""Independent oracles: they share no code with what they test and read nothing of a model but its raw fields."""

from . import elementary as elementary
from . import elliptic as elliptic
from . import published as published
from . import reduced as reduced
from .lagrange import Lagrange as Lagrange
from .state import State as State
from .state import initial_state as initial_state
from .state import parameters_of as parameters_of
from .trajectory import trajectory as trajectory
