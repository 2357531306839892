"""Code generator: from the energies of a model to C source text. Pure: SymPy in, text out, no files touched."""

from .model import Contact as Contact
from .model import Event as Event
from .model import Friction as Friction
from .model import Model as Model
from .model import ModelError as ModelError
from .model import Table as Table
from .model import multiplier as multiplier
from .model import t as t
