"""How the cost and the end of a flight change with its coefficients, from one flight.

The costates that the criteria need, one for each condition at the end and a particular one, are the
sensitivities of those conditions and of the cost to whatever drives the flight.
"""

from dataclasses import dataclass

import numpy as np

from sailnet.ocp.solvers.delta.controls import Controls
from sailnet.ocp.solvers.delta.flight import Flights, Flyer
from sailnet.ocp.solvers.delta.series import zeros
from sailnet.physics.arrays import Array


@dataclass(frozen=True)
class Linear:
    """A flight to first order in its point z.

    Attributes:
        cost: its cost.
        errors: (p,) at its end.
        cost_slope: (d,) of the cost.
        error_slopes: (p, d) of the errors.
    """

    cost: float
    errors: Array
    cost_slope: Array
    error_slopes: Array


def switches(controls: Controls, z: Array) -> list[tuple[float, int]]:
    """Normalised times at which the series of one point vanish, and which of the switched controls."""
    series = controls.coefficients(z[None])[0]
    return sorted(
        (float(s), j)
        for j, switched in enumerate(controls.switched)
        for s in zeros(controls.basis, series[switched.channel])
    )


def aligned(controls: Controls, z: Array, nodes: int) -> Array:
    """Nodes among which are all switches of one point."""
    return np.union1d(np.linspace(0.0, 1.0, nodes + 1), [s for s, _ in switches(controls, z)])


def linearised(flyer: Flyer, z: Array, nodes: int, softness: float = 0.0) -> Linear:
    """The flight of one point to first order, exactly but for the error of its integration.

    Args:
        flyer: flies the problem.
        z: (d,) the point.
        nodes: intervals of the flight, which is cut at its switches besides.
        softness: of the switches; without any, each of them is a jump that moves with its series.
    """
    controls, functions = flyer.controls, flyer.functions
    cuts = [] if softness else switches(controls, z)
    s = np.union1d(np.linspace(0.0, 1.0, nodes + 1), [when for when, _ in cuts])
    flights = flyer.fly(z[None], s, softness)
    last, rates = flyer.final_costates(flights)
    lam = flyer.costates(flights, last)[0]
    state = flights.state.reshape(-1, flights.state.shape[3])
    at = (flights.time.ravel(), state, flights.control.reshape(len(state), -1))
    shape = (*lam.shape[:2], -1)
    running = functions.running_cost(*at).reshape(lam.shape[:2])
    by_u = np.einsum("iknc,iknu->ikcu", lam, functions.dynamics_by_control(*at).reshape(*lam.shape[:3], -1))
    none = np.zeros((1, state.shape[1]))
    by_u[:, :, 0] += functions.hamiltonian_by_control(at[0], at[1], none, at[2]).reshape(shape)
    simpson = np.array([1.0, 4.0, 1.0])[:, None] / 6.0 * flights.widths[0]
    by_series = _by_series(controls, flights, by_u, softness)
    values = controls.basis.values(flights.time[0].ravel() / flights.final_time[0], controls.terms)
    slopes = np.einsum("ik,ikch,ikt->cht", simpson, by_series, values.reshape(*simpson.shape, -1))
    for when, j in cuts:
        switched, k = controls.switched[j], int(np.argmin(np.abs(s - when)))
        own = z[switched.channel * controls.terms : (switched.channel + 1) * controls.terms]
        steep = abs(float((controls.basis.slopes([when], controls.terms) @ own)[0]))
        jump = (switched.upper - switched.lower) * by_u[0, min(k, len(s) - 2), :, switched.column]
        moved = controls.basis.values([when], controls.terms)[0] * flights.final_time[0] / steep
        slopes[:, switched.channel] -= np.outer(jump, moved)
    found = slopes.reshape(len(slopes), -1)
    if flyer.problem.time_is_free:
        # All of the flight is stretched, and the end comes later.
        hamiltonians = np.einsum("iknc,ikn->ikc", lam, functions.dynamics(*at).reshape(lam.shape[:3]))
        hamiltonians[:, :, 0] += running
        stretched = np.einsum("ik,ikc->c", simpson, hamiltonians) / flights.final_time[0] + rates[0]
        found = np.hstack([found, flyer.problem.time_guess * stretched[:, None]])
    final = functions.terminal_cost(flights.final_time, flights.final_state)[0]
    # SLSQP reads the memory of what it is given row by row, whatever its strides.
    found = np.ascontiguousarray(found)
    return Linear(float((simpson * running).sum() + final), flyer.end_errors(flights)[0], found[0], found[1:])


def _by_series(controls: Controls, flights: Flights, by_u: Array, softness: float) -> Array:
    """(3, k, c, channels) derivatives by the series, switches that jump left out."""
    found = np.zeros((*by_u.shape[:3], controls.channels))
    points = by_u.shape[0] * by_u.shape[1]
    series = flights.series[0]
    turned = controls.turned(series.reshape(1, points, -1), by_u.reshape(1, points, *by_u.shape[2:]))
    channels = [channel for pointed in controls.pointed for channel in pointed.channels]
    found[..., channels + [clipped.channel for clipped in controls.clipped]] = turned.reshape(
        *found.shape[:3], -1
    )
    for clipped in controls.clipped:
        found[..., clipped.channel] *= 0.5 * (clipped.upper - clipped.lower)
    if softness:
        for switched in controls.switched:
            steep = 1.0 - np.tanh(series[..., switched.channel] / softness) ** 2
            width = 0.5 * (switched.upper - switched.lower) / softness
            found[..., switched.channel] = -width * steep[..., None] * by_u[..., switched.column]
    return found
