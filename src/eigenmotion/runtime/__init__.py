"""The compiled runtime: generated models as Python objects, and the C headers they are compiled with."""

from . import plain as plain
from . import variations as variations
from .faults import EvaluationError as EvaluationError
from .faults import StopReason as StopReason
from .faults import explain as explain
from .held_back import stiffness as stiffness
from .model import CompiledModel as CompiledModel
from .parts import RunInParts as RunInParts
from .point import Prepared as Prepared
from .record import COUNTS as COUNTS
from .record import modes_of as modes_of
from .record import record as record
from .run import Run as Run
from .stepper import Steps as Steps
from .steppers import ManySteps as ManySteps
