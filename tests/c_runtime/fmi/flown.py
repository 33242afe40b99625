"""Sails steered by instances of an FMU, through the functions of the standard alone."""

import ctypes
from collections.abc import Sequence
from pathlib import Path
from typing import Any

import fmpy
import numpy as np
from fmpy.fmi3 import FMU3Slave
from numpy.typing import ArrayLike, NDArray

from sailnet.guidance.interface import Precision, Steered
from sailnet.mission.mission import Mission
from sailnet.physics.units import TU

OUTPUTS = ("cone_angle", "hold", "time_to_go", "beta_estimate")


class Unpacked:
    """An FMU in a folder: its description, and instances of it."""

    def __init__(self, file: Path, folder: Path) -> None:
        fmpy.extract(str(file), str(folder))
        self.folder = folder
        self.description = fmpy.read_model_description(str(file))
        self.variables = {variable.name: variable for variable in self.description.modelVariables}
        self.references = {name: variable.valueReference for name, variable in self.variables.items()}

    def instance(self, name: str = "sail", log: Any = None) -> FMU3Slave:
        """Instantiated, and no more."""
        made = FMU3Slave(
            instanceName=name,
            guid=self.description.instantiationToken,
            unzipDirectory=str(self.folder),
            modelIdentifier=self.description.coSimulation.modelIdentifier,
        )
        made.instantiate(logMessage=log or (lambda *_: None))
        return made

    def flying(self, name: str = "sail", **parameters: float) -> FMU3Slave:
        """Initialised."""
        made = self.instance(name)
        for parameter, value in parameters.items():
            made.setFloat64([self.references[parameter]], [value])
        made.enterInitializationMode()
        made.exitInitializationMode()
        return made


class FmuGuidance:
    """A :class:`sailnet.guidance.interface.Guidance` for closed loops: it steers, and knows no law alone."""

    def __init__(self, unpacked: Unpacked, mission: Mission, beta_range: tuple[float, float]) -> None:
        self.unpacked, self.mission, self.beta_range = unpacked, mission, beta_range
        self.networks_digest = ""

    def command(self, states: ArrayLike, beta: ArrayLike | None = None) -> Any:
        raise NotImplementedError

    def steering(self, count: int) -> "FmuSteering":
        return FmuSteering(self, count)


class FmuSteering:
    """One instance a sail; each step is a guidance period."""

    def __init__(self, guidance: FmuGuidance, count: int) -> None:
        unpacked = guidance.unpacked
        self._lambda = np.inf  # which the FMU does not show, and the plant does not ask for
        self._instances = [unpacked.flying(str(i)) for i in range(count)]
        self._periods = np.zeros(count, int)
        names = unpacked.references
        inputs, outputs = (names[name] for name in "ruv"), (names[name] for name in OUTPUTS)
        self._inputs, self._outputs = (ctypes.c_uint32 * 3)(*inputs), (ctypes.c_uint32 * 4)(*outputs)
        self._status = (ctypes.c_uint32 * 1)(names["status"])
        # As they are: FMPy's own methods make arrays and take hundreds of them a second.
        dll = self._instances[0].dll
        self._set, self._get, self._get_status = dll.fmi3SetFloat64, dll.fmi3GetFloat64, dll.fmi3GetInt64
        self._step = dll.fmi3DoStep
        self._answers, self._reached = [ctypes.c_bool() for _ in range(3)], ctypes.c_double()

    def steer(
        self, states: ArrayLike, period: float, sails: NDArray[np.intp], attitudes: ArrayLike | None = None
    ) -> Steered:
        assert attitudes is None
        given = np.ascontiguousarray(states, np.float64)
        told, status = np.empty((len(given), 4)), np.empty(len(given), np.int64)
        for place, sail in enumerate(sails):
            told[place], status[place] = self._one(int(sail), given[place], period)
        cone_angle, hold, time_of_flight, beta = told.T
        unknown = np.full(len(given), self._lambda)
        return Steered(cone_angle, hold, time_of_flight, beta, unknown, status.astype(np.int32))

    def _one(self, sail: int, state: NDArray[np.float64], period: float) -> tuple[Sequence[float], int]:
        component = ctypes.c_void_p(self._instances[sail].component)
        given, values, status = (ctypes.c_double * 3)(*state), (ctypes.c_double * 4)(), (ctypes.c_int64 * 1)()
        start = self._periods[sail] * period * TU
        self._periods[sail] += 1
        answers = [ctypes.byref(flag) for flag in self._answers]
        done = [
            self._set(component, self._inputs, 3, given, 3),
            self._step(component, start, period * TU, True, *answers, ctypes.byref(self._reached)),
            self._get(component, self._outputs, 4, values, 4),
            self._get_status(component, self._status, 1, status, 1),
        ]
        assert max(done) <= 1, done  # OK, or the warning of a state that was not valid
        return list(values), status[0]


def precision_of(unpacked: Unpacked) -> Precision:
    """By what the description says of itself."""
    return "float32" if "float32" in unpacked.description.description else "float64"
