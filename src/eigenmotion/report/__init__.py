"""Error against run time: what a tolerance, a method and a formulation buy on this machine."""

from .examine import Ask as Ask
from .examine import Findings as Findings
from .examine import examine as examine
from .files import write_report as write_report
from .measure import Budget as Budget
from .measure import Measurement as Measurement
from .text import recommendation as recommendation
