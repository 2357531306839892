"""The stiff and extreme cases: every formulation, option and method, and what becomes of it."""

from .cases import CASES as CASES
from .examine import examine as examine
from .matrix import Matrix as Matrix
from .matrix import survey as survey
from .outcome import Outcome as Outcome
from .variants import Variant as Variant
from .words import described as described
from .words import summary as summary
from .writing import write_matrix as write_matrix
