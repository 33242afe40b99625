"""Flights of the delta method as solutions."""

import numpy as np

from sailnet.ocp.definition.solution import Solution, Switch, Table
from sailnet.ocp.solvers.delta.method import Delta
from sailnet.ocp.solvers.delta.sensitivity import aligned, switches
from sailnet.physics.arrays import Array


def tabulate(delta: Delta, z: Array) -> Solution:
    """The flight of one point, cut at its switches, as a solution."""
    problem, functions, nodes = delta.problem, delta.judge.exact, delta.options.nodes
    s = aligned(delta.controls, z, 4 * nodes)
    flights, criteria = delta.evaluate(z[None], s)
    coarse = delta.judge.flyer.fly(z[None], aligned(delta.controls, z, 2 * nodes))
    stop = float(flights.final_time[0])
    cuts = switches(delta.controls, z)
    # Begin of every interval and the last end; at a switch the end of the interval before as well.
    ends = np.isin(s[1:], [when for when, _ in cuts])
    ends[-1] = True
    rows = sorted([(k, 0) for k in range(len(s) - 1)] + [(int(k), 2) for k in np.flatnonzero(ends)])
    k, i = np.array(rows).T
    clock, x, u = flights.time[0, i, k], flights.state[0, i, k], flights.control[0, i, k]
    costate = criteria.costate[0, i, k]
    y = np.hstack([x, costate])
    modes = np.zeros((len(y), len(problem.bounded)))
    table = Table(
        time=clock,
        state=x,
        costate=costate,
        control=u,
        switching=functions.switching(clock, y, modes),
        hamiltonian=delta.judge.flyer.functions.hamiltonian(clock, x, costate, u),
    )
    residuals = {
        "boundary": float(criteria.worst_end[0]),
        "dynamics": float(np.abs(flights.final_state - coarse.final_state).max()) / 15.0,
        "delta_s_h": float(criteria.delta_s_h[0]),
        "delta_s_i": float(criteria.delta_s_i[0]),
        "delta_u": float(criteria.delta_u[0]),
    }
    if problem.time_is_free:
        residuals["delta_h"] = float(criteria.delta_h[0])
    names = [problem.bounded[switched.index].switching for switched in delta.controls.switched]
    channels = [switched.channel for switched in delta.controls.switched]
    coefficients = delta.controls.coefficients(z[None])[0]
    passed = [
        # A control rises where its series falls.
        Switch(
            when * stop,
            names[j],
            bool(delta.controls.basis.slopes([when], delta.controls.terms) @ coefficients[channels[j]] < 0.0),
        )
        for when, j in cuts
    ]
    return Solution(
        problem=problem.name,
        solver="delta method",
        **table,
        cost=float(criteria.cost[0]),
        residuals=residuals,
        switches=passed,
        names=problem.names,
        message=f"{len(passed)} switches",
    )
