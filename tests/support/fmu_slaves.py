"""A Functional Mock-up Unit, as fmpy, which knows nothing of us, opens it."""

from ctypes import byref, c_char_p

import pytest

fmpy = pytest.importorskip("fmpy")
fmi2 = pytest.importorskip("fmpy.fmi2")
fmi3 = pytest.importorskip("fmpy.fmi3")


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


class Slave:
    """One instance of a unit of FMI 3.0, by fmpy; `said` is what it has told its log."""

    def __init__(self, path, folder):
        self.description = fmpy.read_model_description(str(path))
        self.places = {one.name: one.valueReference for one in self.description.modelVariables}
        self.said: list[str] = []
        self.folder = folder
        fmpy.extract(str(path), str(folder))
        self.slave = fmi3.FMU3Slave(guid=self.description.guid, unzipDirectory=str(folder), instanceName="one",
                          modelIdentifier=self.description.coSimulation.modelIdentifier)  # fmt: skip
        self.slave.instantiate(logMessage=self.log)

    def log(self, environment, status, category, message):
        self.said.append(message.decode())

    def begin(self, **start):
        self.slave.enterInitializationMode(tolerance=1e-9, startTime=0.0)
        self.slave.setFloat64([self.places[name] for name in start], list(start.values()))
        self.slave.exitInitializationMode()
        return self

    def get(self, *names):
        return self.slave.getFloat64([self.places[name] for name in names])


def exchanged(path, t_end, **options):
    """The rows of a motion that fmpy's solver integrates, every hundredth of a second."""
    return fmpy.simulate_fmu(
        str(path), stop_time=t_end, output_interval=0.01, relative_tolerance=1e-11, fmi_type="ModelExchange", **options
    )


def stepped(path, t_end, **options):
    """The rows of a motion that the unit steps, every hundredth of a second."""
    return fmpy.simulate_fmu(
        str(path), stop_time=t_end, output_interval=0.01, relative_tolerance=1e-9, fmi_type="CoSimulation", **options
    )
