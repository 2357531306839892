"""What generated code computes and leaves out, as a picture and as text."""

from .picture import figure as figure
from .savings import Savings as Savings
from .savings import savings_of as savings_of
from .savings import table as table
