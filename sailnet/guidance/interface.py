"""Guidance: states in, commands and status codes out, whatever the back end that computes them."""

from dataclasses import dataclass
from enum import IntEnum
from typing import Literal, Protocol, runtime_checkable

import numpy as np
from numpy.typing import ArrayLike, NDArray

from sailnet.errors import GuidanceError
from sailnet.mission.mission import Mission
from sailnet.physics.arrays import Array
from sailnet.physics.geometry import geometry_of

Precision = Literal["float32", "float64"]

Layout = Literal["flight", "host"]
"""Of the exported C: the file that goes on board, or the same on vectors, for simulation."""


class GuidanceStatus(IntEnum):
    """What the guidance says about its command, as in ``sailnet_guidance.h``."""

    OK = 0
    """The command is for a state that the networks know."""
    ARRIVED = 1
    """The flight ends: of one command, the predicted time of flight is below the mission's threshold."""
    OUTSIDE_DOMAIN = 2
    """The networks were not trained on such a state or such a beta."""
    INVALID_INPUT = 3
    """Nothing is known of the state: the sail is to face the Sun."""
    RECKONED = 4
    """From steering: there is no state, and the command is for where the sail must be."""
    AT_LIMIT = 5
    """From steering: the sail is weaker than the networks have learnt, and no thrust margin is left."""

    @property
    def label(self) -> str:
        """As people read it."""
        return self.name.lower().replace("_", " ")


@dataclass(frozen=True)
class Commands:
    """Commands for n sails.

    Attributes:
        cone_angle: (n,) [rad], always within the mission's bound, Eq. (3).
        time_of_flight: (n,) predicted time of flight to the target orbit [TU].
        lambda_v: (n,) costate of v times beta / r_f^2, where that is small: its size says what the other
            sign of the cone angle costs. Infinite if the guidance does not know it: steering then obeys it.
        status: (n,) values of GuidanceStatus.
        clock_angle: (n,) from the transverse direction to the north [rad], in (-pi, pi]; None in the plane,
            where the cone angle has a sign instead.
        lambda_w: (n,) costate of w, scaled as ``lambda_v``; None in the plane.
    """

    cone_angle: Array
    time_of_flight: Array
    lambda_v: Array
    status: NDArray[np.int32]
    clock_angle: Array | None = None
    lambda_w: Array | None = None


@dataclass(frozen=True)
class Steered:
    """What n sails are to do; arrays of length n.

    Attributes:
        cone_angle: to hold [rad], within the mission's bound.
        hold: for how long [TU]: the period, or less where the flight ends.
        time_of_flight: predicted to the target orbit [TU].
        beta: estimate of the normalised characteristic acceleration.
        lambda_v: as of ``Commands``.
        status: values of ``GuidanceStatus``: ``ARRIVED`` where the flight ends, ``RECKONED`` or ``AT_LIMIT``
            by what steering knows, else of the command.
        clock_angle, lambda_w: as of ``Commands``.
    """

    cone_angle: Array
    hold: Array
    time_of_flight: Array
    beta: Array
    lambda_v: Array
    status: NDArray[np.int32]
    clock_angle: Array | None = None
    lambda_w: Array | None = None

    @property
    def arrived(self) -> NDArray[np.bool_]:
        """(n,) the flight ends after ``hold``."""
        return np.asarray(self.status == GuidanceStatus.ARRIVED)


class Steering(Protocol):
    """Memories of a number of sails, and the guidance that steers them."""

    def steer(
        self, states: ArrayLike, period: float, sails: NDArray[np.intp], attitudes: ArrayLike | None = None
    ) -> Steered:
        """Steer some of the sails.

        Where a state is not finite the sail is steered for a while by where it must be, and then gets the
        safe command for a period; a period that is not positive, or longer than steering takes, gets it
        with ``hold`` 0.

        Args:
            states: (n, 3) r, u, v now, or (n, 5), after what was commanded last was held.
            period: guidance period [TU].
            sails: (n,) which of the sails these are.
            attitudes: (n,) mean cone angles over the period that ends, as measured [rad]; NaN where not. In
                space none are taken yet.
        """


@runtime_checkable
class NativeSteering(Steering, Protocol):
    """Steering that C can do without Python in between."""

    def native(self) -> tuple[int, int, Precision]:
        """Address of a ``sailnet_steer_batch``, of its memories, and the precision of both."""


class Guidance(Protocol):
    """Something that flies: the exported C, an ONNX graph, or a test double."""

    @property
    def mission(self) -> Mission:
        """The mission it was made for."""

    @property
    def networks_digest(self) -> str:
        """SHA-256 over the weights that fly: equal means the same networks, whatever the back end."""

    @property
    def beta_range(self) -> tuple[float, float]:
        """Smallest and largest beta the networks were trained for."""

    def command(self, states: ArrayLike, beta: ArrayLike | None = None) -> Commands:
        """Command the sails at (n, 3) states (r, u, v) [AU, AU/TU, AU/TU], in space at (n, 5).

        Any numbers give a bounded command, NaN and infinities included; see GuidanceStatus.

        Args:
            states: rows r, u, v; in space r, latitude [rad], u, v, w.
            beta: (n,) or one normalised characteristic acceleration, clamped to ``beta_range``; the
                mission's by default, and in place of NaN.

        Raises:
            GuidanceError: ``states`` or ``beta`` has another shape.
        """

    def steering(self, count: int) -> Steering:
        """Steering of ``count`` sails that start knowing nothing but the mission's beta."""


@runtime_checkable
class FirstPlans(Protocol):
    """A guidance with networks of the arrival costates: they give plans to begin with."""

    def arrival_directions(self, states: ArrayLike, beta: ArrayLike | None = None) -> Array | None:
        """Directions of the arrival costates of optimal extremals from some states, by networks.

        Args:
            states: as of :meth:`command`.
            beta: likewise.

        Returns:
            (n, 3), in space (n, 5), of any size; None if it has no networks for it.
        """

    @property
    def known_plans(self) -> Array:
        """(k, 8) known plans, in space (k, 12): see :attr:`sailnet.networks.known_plans.KnownPlans.rows`."""


def as_states(states: ArrayLike, precision: Precision, components: int = 3) -> NDArray[np.floating]:
    """(n, 3) contiguous array of one precision, in space (n, 5); numbers beyond its range become infinite.

    Args:
        states: rows of numbers.
        precision: of the array.
        components: of a state.

    Raises:
        GuidanceError: another shape, or not numbers.
    """
    shape = f"(n, {components})"
    array = _as_numbers(states, precision, f"states must be numbers in an {shape} array")
    if array.ndim != 2 or array.shape[1] != components:
        names = ", ".join(geometry_of(components).state_names)
        raise GuidanceError(f"states must be an {shape} array of ({names}), not of shape {array.shape}")
    return array


def as_attitudes(attitudes: ArrayLike, count: int, precision: Precision) -> NDArray[np.floating]:
    """(count,) contiguous array of one precision; numbers beyond its range become infinite.

    Raises:
        GuidanceError: another shape, or not numbers.
    """
    array = _as_numbers(attitudes, precision, "attitudes must be numbers")
    if array.shape != (count,):
        raise GuidanceError(f"{count} states need as many attitudes, not an array of shape {array.shape}")
    return array


def refuse_attitudes(mission: Mission, attitudes: ArrayLike | None) -> None:
    """Raise an error if attitudes are measured that steering does not take yet: those of three dimensions.

    Raises:
        GuidanceError: they are.
    """
    if attitudes is not None and mission.inclined:
        raise GuidanceError("in three dimensions steering takes no measured attitudes yet")


def _as_numbers(values: ArrayLike, precision: Precision, must: str) -> NDArray[np.floating]:
    """A contiguous array of one precision; what it ``must`` be, and is not, is said."""
    try:
        with np.errstate(over="ignore"):
            return np.ascontiguousarray(values, dtype=precision)
    except (TypeError, ValueError) as error:
        raise GuidanceError(f"{must}: {error}") from error


def as_betas(
    beta: ArrayLike | None, count: int, nominal: float, precision: Precision
) -> NDArray[np.floating]:
    """(count,) contiguous array of one precision; NaN, like no beta at all, becomes ``nominal``.

    Raises:
        GuidanceError: neither one number nor as many as there are states.
    """
    try:
        with np.errstate(over="ignore"):
            given = np.asarray(nominal if beta is None else beta, precision)
        array = np.broadcast_to(given, count)
    except (TypeError, ValueError) as error:
        raise GuidanceError(f"beta must be one number, or one for each of {count} states: {error}") from error
    return np.ascontiguousarray(np.where(np.isnan(array), np.asarray(nominal, precision), array))
