"""A Functional Mock-up Unit, as fmpy, which knows nothing of us, opens it."""

from ctypes import byref, c_char_p

import pytest

fmpy = pytest.importorskip("fmpy")
fmi2 = pytest.importorskip("fmpy.fmi2")


class Unit:
    """One instance of a unit, by fmpy."""

    def __init__(self, path, folder, name="one"):
        self.description = fmpy.read_model_description(str(path))
        self.places = {variable.name: variable.valueReference for variable in self.description.modelVariables}
        self.said: list[str] = []
        if not folder.exists():
            fmpy.extract(str(path), str(folder))
        self.slave = fmi2.FMU2Slave(
            guid=self.description.guid, unzipDirectory=str(folder), instanceName=name,
            modelIdentifier=self.description.coSimulation.modelIdentifier,
        )  # fmt: skip
        self.slave.instantiate()

    def begin(self, **start):
        self.slave.setupExperiment(tolerance=1e-9, startTime=0.0)
        self.slave.enterInitializationMode()
        self.set(**start)
        self.slave.exitInitializationMode()
        return self

    def set(self, **values):
        self.slave.setReal([self.places[name] for name in values], list(values.values()))

    def get(self, *names):
        return self.slave.getReal([self.places[name] for name in names])

    @property
    def words(self):
        """What it said last."""
        said = c_char_p()
        self.slave.fmi2GetStringStatus(self.slave.component, 0, byref(said))
        return said.value.decode()

    def step(self, t, h):
        self.slave.doStep(currentCommunicationPoint=t, communicationStepSize=h)
        return self
