"""Mechanism models: the user's SymPy expressions, checked and normalised."""

from .model import Model as Model
from .model import ModelError as ModelError
from .model import multiplier as multiplier
from .model import t as t
from .statement import draw as draw
from .statement.contacts import Contact as Contact
from .statement.contacts import Friction as Friction
from .statement.event import Event as Event
from .table import Table as Table
from .tree.tree import Tree as Tree
