"""Error against run time: what a tolerance, a method and a formulation buy on this machine."""

from .examine import Ask as Ask
from .examine import Findings as Findings
from .examine import examine as examine
from .measure import Budget as Budget
from .measure import Measurement as Measurement
from .words import recommendation as recommendation
from .writing import write_report as write_report
