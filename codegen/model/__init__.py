"""What a mechanism is: the user's SymPy, checked and in one form."""

from . import draw as draw
from .contacts import Contact as Contact
from .contacts import Friction as Friction
from .event import Event as Event
from .model import Model as Model
from .model import ModelError as ModelError
from .model import multiplier as multiplier
from .model import t as t
