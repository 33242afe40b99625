"""What every exported guidance says about itself, whatever the back end that flies it."""

import json
from collections.abc import Mapping
from dataclasses import asdict, dataclass

import numpy as np
from numpy.typing import ArrayLike, DTypeLike, NDArray

from sailnet import __version__
from sailnet.artefacts.untrusted import table_of
from sailnet.errors import GuidanceError, SailnetError
from sailnet.guidance.interface import Commands, GuidanceStatus
from sailnet.mission.mission import Mission
from sailnet.mission.sections import NO_DEGRADATION, Degradation
from sailnet.networks.guidance_in_space import AnyGuidanceNetworks
from sailnet.networks.network import Network, weights_digest
from sailnet.networks.plan_networks import PlanNetworks
from sailnet.networks.trained_domain import TrainedDomain
from sailnet.physics.arrays import Array
from sailnet.physics.geometry import lengths_of, target_of
from sailnet.physics.optics import OPTICS, Optics, is_number, optics_from

METADATA_KEY = "sailnet_guidance"
"""The key of an ONNX file's ``metadata_props`` that holds the facts as JSON."""

_TEXTS = ("version", "mission", "mission_digest", "networks_digest")
_STATES = ("target_state", "state_min", "state_max")
_NUMBERS = (
    *("phi_max", "arrival_threshold", "arrival_tolerance", "largest_time_of_flight"),
    *("beta", "beta_min", "beta_max", "costate_unit", "turn_rate"),
)


@dataclass(frozen=True)
class GuidanceFacts:
    """Where an exported guidance comes from, and the constants its status codes depend on.

    Attributes:
        version: of the sailnet that exported it.
        mission: name of the mission.
        mission_digest: ``Mission.digest()``; another digest is another problem.
        networks_digest: SHA-256 over the weights and scaling of all networks, and the known plans, hex.
        datasets: digest of the data set of each network, as its trainer recorded it.
        phi_max: bound on the cone angle [rad], Eq. (3).
        arrival_threshold: a shorter predicted time of flight is an arrival [TU].
        arrival_tolerance: arrived means each of r, u, v within this of the target [AU, AU/TU]; in space also
            the latitude times the target's radius, and w.
        largest_time_of_flight: the networks were trained on no longer one [TU].
        beta: the mission's normalised characteristic acceleration.
        beta_min, beta_max: range of it the networks were trained on.
        costate_unit: of the outputs of ``lambda_v`` and ``lambda_w``, see ``GuidanceNetworks.costate_unit``.
        turn_rate: how fast the sail turns [rad/TU].
        target_state: (r, u, v) on the target orbit, or in space (r, latitude, u, v, w).
        state_min, state_max: box of such states that the time-of-flight network was trained on.
        domain: the tube of trained states within it.
        optics: of the sail that was trained for and flies; ideal where nothing was said.
        degradation: how that sail is known to age; not at all where nothing was said.
        known_plans: rows of :attr:`sailnet.networks.known_plans.KnownPlans.rows`, if there are any.
    """

    version: str
    mission: str
    mission_digest: str
    networks_digest: str
    datasets: Mapping[str, str]
    phi_max: float
    arrival_threshold: float
    arrival_tolerance: float
    largest_time_of_flight: float
    beta: float
    beta_min: float
    beta_max: float
    costate_unit: float
    turn_rate: float
    target_state: tuple[float, ...]
    state_min: tuple[float, ...]
    state_max: tuple[float, ...]
    domain: TrainedDomain
    optics: Optics = OPTICS["ideal"]
    degradation: Degradation = NO_DEGRADATION
    known_plans: tuple[tuple[float, ...], ...] = ()

    def __post_init__(self) -> None:
        for name, value in vars(self).items():
            if name in _TEXTS and not isinstance(value, str):
                raise GuidanceError(f"{name} is {value!r:.40}, not text")
            if name in _STATES and not (len(value) == self.components and all(map(_is_finite, value))):
                raise GuidanceError(f"{name} is {value!r:.60}, not {self.components} finite numbers")
            if name in _NUMBERS and not (_is_finite(value) and value > 0.0):
                raise GuidanceError(f"{name} is {value!r:.40}, not a finite number above 0")
        of_a_plan = 2 * self.components + 2
        for row in self.known_plans:
            if not (len(row) == of_a_plan and all(map(_is_finite, row))):
                raise GuidanceError(f"a known plan is {row!r:.60}, not {of_a_plan} finite numbers")
        if not isinstance(self.datasets, Mapping) or not all(
            isinstance(value, str) for value in self.datasets.values()
        ):
            raise GuidanceError(f"datasets is {self.datasets!r:.60}, not a table of texts")

    @property
    def components(self) -> int:
        """Of a state: 3, or 5 in space."""
        return self.domain.components

    @property
    def known(self) -> Array:
        """(k, 2 components + 2) the known plans."""
        return np.array(self.known_plans, float).reshape(-1, 2 * self.components + 2)

    @property
    def tolerances(self) -> Array:
        """(k,) by how much each component of a state may differ from the target's on arrival."""
        return self.arrival_tolerance / lengths_of(self.target_state)

    def contains(self, states: ArrayLike, beta: ArrayLike) -> NDArray[np.bool_]:
        """(n,) whether the networks were trained on such states and sails; never on what is not finite.

        beta within its range, the state within the box, and within the tube or at the target. The range
        and the box are rounded as the states are.

        Args:
            states: (n, 3) rows r [AU], u, v [AU/TU]; in space (n, 5) rows r, latitude [rad], u, v, w.
            beta: (n,) normalised characteristic accelerations.
        """
        state, sail = np.asarray(states), np.asarray(beta)
        low, high = np.array(self.state_min, state.dtype), np.array(self.state_max, state.dtype)
        inside = ((state >= low) & (state <= high)).all(axis=1)
        inside &= (sail >= sail.dtype.type(self.beta_min)) & (sail <= sail.dtype.type(self.beta_max))
        # What is outside is not evaluated any further.
        known = np.where(inside[:, None], state, self.target_state).astype(float)
        sails = np.where(inside, sail, self.beta).astype(float)
        at_target = (np.abs(known - self.target_state) <= self.tolerances).all(axis=1)
        within = self.domain.excess(known, sails, self.target_state) <= 0.0
        return np.asarray(inside & (at_target | within))

    def commands(
        self,
        states: ArrayLike,
        beta: ArrayLike,
        cone_angle: ArrayLike,
        time_of_flight: ArrayLike,
        lambda_v: ArrayLike = np.inf,
        clock_angle: ArrayLike | None = None,
        lambda_w: ArrayLike | None = None,
    ) -> Commands:
        """What networks gave for these states, with the status of each: the rules of ``sailnet_guidance.h``.

        The threshold of arrival is rounded as the time of flight is. A state that is not finite gets the safe
        command.

        Args:
            states: (n, 3) or (n, 5) rows, as in :meth:`contains`.
            beta: (n,) normalised characteristic accelerations.
            cone_angle: (n,) [rad].
            time_of_flight: (n,) [TU].
            lambda_v: (n,) in units of r_f^2 / beta; by default not known.
            clock_angle: (n,) [rad], in space.
            lambda_w: (n,) in the same units, in space.
        """
        state, angle, tau = np.asarray(states), np.asarray(cone_angle), np.asarray(time_of_flight)
        valid = np.isfinite(state).all(axis=1)
        status = np.full(len(state), GuidanceStatus.OK, np.int32)
        status[tau < tau.dtype.type(self.arrival_threshold)] = GuidanceStatus.ARRIVED
        status[~self.contains(state, beta)] = GuidanceStatus.OUTSIDE_DOMAIN
        status[~valid] = GuidanceStatus.INVALID_INPUT
        return Commands(
            cone_angle=np.where(valid, angle, 0.0).astype(np.float64),
            time_of_flight=np.where(valid, tau, self.largest_time_of_flight).astype(np.float64),
            lambda_v=np.where(valid, lambda_v, 0.0).astype(np.float64),
            status=status,
            clock_angle=None if clock_angle is None else np.where(valid, clock_angle, 0.0).astype(np.float64),
            lambda_w=None if lambda_w is None else np.where(valid, lambda_w, 0.0).astype(np.float64),
        )

    def to_json(self) -> str:
        """One line of JSON."""
        content = asdict(self)
        if self.degradation == NO_DEGRADATION:  # as before a mission could say so
            del content["degradation"]
        else:
            content["degradation"] = self.degradation.model_dump()
        return json.dumps(content, sort_keys=True)

    @classmethod
    def from_json(cls, text: str) -> "GuidanceFacts":
        """Read what ``to_json`` wrote.

        Raises:
            GuidanceError: it is not that.
        """
        try:
            content = table_of(text)
            for name in _STATES:
                content[name] = tuple(content[name])
            content["known_plans"] = tuple(map(tuple, content.get("known_plans", ())))
            content["domain"] = TrainedDomain.parse(content["domain"])
            content["optics"] = optics_from(content.get("optics", "ideal"))
            content["degradation"] = Degradation(**content.get("degradation", {}))
            return cls(**content)
        except (ValueError, KeyError, TypeError, SailnetError) as error:
            raise GuidanceError(f"the guidance does not say what it is: {error}; export it again") from error


def describe(
    networks: AnyGuidanceNetworks,
    mission: Mission,
    alpha: Network | None = None,
    plan: PlanNetworks | None = None,
) -> GuidanceFacts:
    """Facts of networks flown by the rules of ``mission``.

    Args:
        networks: of the plane or of space.
        mission: the mission that is flown.
        alpha: the network that flies instead of ``alpha_pre`` and ``lambda_v``, for the baseline.
        plan: networks of a first plan, if there are any.

    Raises:
        NetworkError: the networks do not say what states they were trained on.
    """
    flown = networks.all if alpha is None else (networks.tau, alpha)
    flown = (*flown, *(() if plan is None else plan.all))
    known = None if plan is None else plan.known
    lowest, highest = networks.state_range
    beta_min, beta_max = networks.beta_range
    return GuidanceFacts(
        version=__version__,
        mission=mission.name,
        mission_digest=mission.digest(),
        networks_digest=weights_digest(flown, None if plan is None else plan.tables),
        datasets={n.name: str(n.provenance.get("dataset", "not recorded")) for n in flown},
        phi_max=mission.problem.phi_max,
        arrival_threshold=mission.flight.arrival_threshold,
        arrival_tolerance=mission.flight.arrival_tolerance,
        largest_time_of_flight=networks.longest,
        beta=mission.sail.beta,
        beta_min=beta_min,
        beta_max=beta_max,
        costate_unit=networks.costate_unit,
        turn_rate=mission.flight.turn_rate,
        target_state=tuple(map(float, target_of(mission.problem, networks.components))),
        state_min=tuple(map(float, lowest)),
        state_max=tuple(map(float, highest)),
        domain=networks.domain,
        optics=mission.sail.optics,
        degradation=mission.degradation,
        known_plans=() if known is None else tuple(map(_shortest, known.rows)),
    )


def _shortest(row: Array) -> tuple[float, ...]:
    """Numbers of single precision, by the shortest decimals that read back so."""
    return tuple(float(str(number)) for number in row.astype(np.float32))


def _is_finite(value: object) -> bool:
    try:
        return is_number(value) and bool(np.isfinite(float(value)))  # type: ignore[arg-type]
    except OverflowError:
        return False


def round_down(value: float, precision: DTypeLike) -> float:
    """The largest number of this precision that does not exceed ``value``."""
    nearest = np.asarray(value, precision)
    below = np.nextafter(nearest, np.asarray(-np.inf, precision))
    return float(nearest if float(nearest) <= value else below)
