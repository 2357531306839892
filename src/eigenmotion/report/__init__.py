"""Report of error against run time for tolerances, methods and formulations on this machine."""

from .examine import Findings as Findings
from .examine import ReportOptions as ReportOptions
from .examine import examine as examine
from .measure import Budget as Budget
from .measure import Measurement as Measurement
