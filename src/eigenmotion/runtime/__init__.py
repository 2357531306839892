"""The compiled runtime: generated models as Python objects, and the C headers they are compiled with."""

from .core import CompiledModel as CompiledModel
from .core import Prepared as Prepared
from .core import Run as Run
from .faults import EvaluationError as EvaluationError
from .faults import StopReason as StopReason
from .faults import explain as explain
