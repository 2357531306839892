"""The paper's experiment: Figures 2 to 8 from our runs, and the paper's statements compared with our numbers.

Junkins & Schaub, "An Instantaneous Eigenstructure Quasivelocity Formulation for Nonlinear Multibody Dynamics",
J. Astronautical Sciences 45 (1997), section "Multi-link simulation". `python -m eigenmotion.paper DIR` draws them.
"""

from .figures import Figures as Figures
from .figures import write_figures as write_figures
from .findings import Finding as Finding
from .findings import Verdict as Verdict
from .findings import findings as findings
