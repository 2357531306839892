from typing import Any

from .point import Prepared, Vector
from .run import Run

class Checkpoint:
    t: float
    y: Vector
    prepared: Prepared
    saved: bytes
    steps: int

class CheckpointedRun(Run):
    checkpoints: list[Checkpoint]
    def __init__(self, task: Any, method: int, steps: int) -> None: ...

class ReplayedRun(Run):
    def __init__(self, task: Any, method: int, checkpoint: Checkpoint) -> None: ...
