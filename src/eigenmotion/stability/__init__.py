"""Stability matrix: stiff and extreme cases with every formulation, option and method, and the outcome of each run."""

from .cases.catalogue import CASES as CASES
from .cases.variants import Variant as Variant
from .evaluation.examine import examine as examine
from .evaluation.matrix import Matrix as Matrix
from .evaluation.matrix import survey as survey
from .evaluation.outcome import Outcome as Outcome
from .limits.files import write_limits as write_limits
from .limits.survey import BUDGET as BUDGET
from .limits.survey import Limits as Limits
from .limits.survey import limits_of as limits_of
from .limits.text import summary_of as summary_of
from .output.files import write_matrix as write_matrix
from .output.text import described as described
from .output.text import summary as summary
