"""The compiled runtime: generated models as Python objects, and the C headers they are compiled with."""

from . import variations as variations
from .incremental_run import IncrementalRun as IncrementalRun
from .incremental_run import IncrementalRuns as IncrementalRuns
from .model import CompiledModel as CompiledModel
from .point import Actuators as Actuators
from .point import Prepared as Prepared
from .record import COUNTS as COUNTS
from .record import modes_of as modes_of
from .record import record as record
from .run import Run as Run
from .status.stiffness import stiffness as stiffness
from .status.stop_reasons import MAYBE_UNDEFINED as MAYBE_UNDEFINED
from .status.stop_reasons import EvaluationError as EvaluationError
from .status.stop_reasons import StopReason as StopReason
from .status.stop_reasons import explain as explain
from .stepper import Steps as Steps
from .steppers import ManySteps as ManySteps
