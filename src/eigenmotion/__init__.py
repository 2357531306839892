"""A compiler from energies to motion.

Modules are imported when a name is first used, so that `eigenmotion --help` does not wait for SymPy and SciPy.
"""

from importlib import import_module
from typing import TYPE_CHECKING

from .garbage import uncollected

if TYPE_CHECKING:
    from .analysis.continuation.branch import Branch as Branch
    from .analysis.continuation.follow import follow as follow
    from .analysis.cycles.cycle import Cycle as Cycle
    from .analysis.cycles.find_cycle import find_cycle as find_cycle
    from .analysis.driving.drive import drive as drive
    from .analysis.equilibrium.assemble import assemble as assemble
    from .analysis.equilibrium.equilibrium import find_equilibrium as find_equilibrium
    from .analysis.fitting.fit import fit as fit
    from .analysis.fitting.motion_fit import MotionFit as MotionFit
    from .analysis.gradients.to_jax import to_jax as to_jax
    from .analysis.gradients.to_torch import to_torch as to_torch
    from .analysis.gradients.vjp import vjp as vjp
    from .analysis.identification.fit_forces import Fit as Fit
    from .analysis.identification.fit_forces import fit_forces as fit_forces
    from .analysis.identification.identifiable import Identifiable as Identifiable
    from .analysis.identification.identifiable import identifiable as identifiable
    from .analysis.identification.regressor import Regressor as Regressor
    from .analysis.linear.linearization import Linearization as Linearization
    from .analysis.lyapunov.exponents import Lyapunov as Lyapunov
    from .analysis.lyapunov.lyapunov import lyapunov as lyapunov
    from .arguments.sampled import Sampled as Sampled
    from .arguments.signals import Signal as Signal
    from .batch.simulate_ensemble import simulate_ensemble as simulate_ensemble
    from .batch.stepper.steppers import Steppers as Steppers
    from .building.build import build as build
    from .building.errors import BuildError as BuildError
    from .building.errors import CompilerNotFoundError as CompilerNotFoundError
    from .building.model_file import load_model as load_model
    from .building.verification import ProofError as ProofError
    from .casadi.export import export_casadi as export_casadi
    from .codegen.mechanics import from_mechanics as from_mechanics
    from .codegen.model import Contact as Contact
    from .codegen.model import Event as Event
    from .codegen.model import Friction as Friction
    from .codegen.model import Model as Model
    from .codegen.model import ModelError as ModelError
    from .codegen.model import Table as Table
    from .codegen.model import Tree as Tree
    from .codegen.model import multiplier as multiplier
    from .codegen.model import t as t
    from .codegen.model.statement import draw as draw
    from .fmu.export import export_fmu as export_fmu
    from .gym.gym_env import gym_env as gym_env
    from .results.drive import Drive as Drive
    from .results.ensemble import Ensemble as Ensemble
    from .results.solution import Solution as Solution
    from .robots.load import load_mjcf as load_mjcf
    from .robots.load import load_urdf as load_urdf
    from .robots.load import read_mjcf as read_mjcf
    from .robots.load import read_urdf as read_urdf
    from .robots.robot import Robot as Robot
    from .runtime import EvaluationError as EvaluationError
    from .runtime import StopReason as StopReason
    from .simulation.simulate import simulate as simulate
    from .simulation.stepper import Stepper as Stepper
    from .system.system import System as System
    from .webpage.page_object import show as show

_HOME = {
    "Branch": ".analysis.continuation.branch",
    "BuildError": ".building.errors",
    "CompilerNotFoundError": ".building.errors",
    "Contact": ".codegen.model",
    "Cycle": ".analysis.cycles.cycle",
    "Drive": ".results.drive",
    "Ensemble": ".results.ensemble",
    "EvaluationError": ".runtime",
    "Event": ".codegen.model",
    "Fit": ".analysis.identification.fit_forces",
    "Friction": ".codegen.model",
    "Identifiable": ".analysis.identification.identifiable",
    "Linearization": ".analysis.linear.linearization",
    "Lyapunov": ".analysis.lyapunov.exponents",
    "Model": ".codegen.model",
    "ModelError": ".codegen.model",
    "MotionFit": ".analysis.fitting.motion_fit",
    "ProofError": ".building.verification",
    "Regressor": ".analysis.identification.regressor",
    "Robot": ".robots.robot",
    "Sampled": ".arguments.sampled",
    "Signal": ".arguments.signals",
    "Solution": ".results.solution",
    "Stepper": ".simulation.stepper",
    "Steppers": ".batch.stepper.steppers",
    "StopReason": ".runtime",
    "System": ".system.system",
    "Table": ".codegen.model",
    "Tree": ".codegen.model",
    "assemble": ".analysis.equilibrium.assemble",
    "build": ".building.build",
    "draw": ".codegen.model",
    "drive": ".analysis.driving.drive",
    "find_cycle": ".analysis.cycles.find_cycle",
    "find_equilibrium": ".analysis.equilibrium.equilibrium",
    "fit": ".analysis.fitting.fit",
    "fit_forces": ".analysis.identification.fit_forces",
    "follow": ".analysis.continuation.follow",
    "from_mechanics": ".codegen.mechanics",
    "export_casadi": ".casadi.export",
    "export_fmu": ".fmu.export",
    "gym_env": ".gym.gym_env",
    "identifiable": ".analysis.identification.identifiable",
    "load_mjcf": ".robots.load",
    "load_model": ".building.model_file",
    "load_urdf": ".robots.load",
    "lyapunov": ".analysis.lyapunov.lyapunov",
    "multiplier": ".codegen.model",
    "read_mjcf": ".robots.load",
    "read_urdf": ".robots.load",
    "show": ".webpage.page_object",
    "simulate": ".simulation.simulate",
    "simulate_ensemble": ".batch.simulate_ensemble",
    "t": ".codegen.model",
    "to_jax": ".analysis.gradients.to_jax",
    "to_torch": ".analysis.gradients.to_torch",
    "vjp": ".analysis.gradients.vjp",
}

__all__ = list(_HOME)


def __getattr__(name: str) -> object:
    if name not in _HOME:
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
    with uncollected():
        value = getattr(import_module(_HOME[name], __name__), name)
    globals()[name] = value
    return value


def __dir__() -> list[str]:
    return sorted({*globals(), *_HOME})
