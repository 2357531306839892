"""Where pickles of earlier versions look for what remakes a model, its prepared parameters and a run's interpolants."""

from .point import _compiled as _compiled
from .point import _prepared as _prepared
from .run import _kept as _kept
