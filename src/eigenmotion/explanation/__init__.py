"""Picture of generated code: M, A, the terms, and what each saving is worth."""

from .picture import figure as figure
from .savings import Savings as Savings
from .savings import savings_of as savings_of
from .savings import table as table
