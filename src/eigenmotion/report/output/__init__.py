"""Page, pictures, numbers and sentences of a report."""

from .files import write_report as write_report
from .text import recommendation as recommendation
