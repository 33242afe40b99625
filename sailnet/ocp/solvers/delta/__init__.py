"""The delta method of paper 004: series for the controls, a heuristic for their coefficients.

GA-PSO and CMA-ES need pygmo, the extra `ocp`; the imperialist competitive algorithm needs nothing.

options = delta.Options(basis=delta.Chebyshev(), heuristic=delta.Imperialist())
solution = delta.solve(lunar_landing.problem(), options=options)
"""

from sailnet.ocp.solvers.delta.criteria import Weights
from sailnet.ocp.solvers.delta.heuristics import CmaEs, GaPso, Heuristic
from sailnet.ocp.solvers.delta.imperialist import Imperialist
from sailnet.ocp.solvers.delta.options import Options, RandomSeries
from sailnet.ocp.solvers.delta.polish import Polish
from sailnet.ocp.solvers.delta.series import Basis, Chebyshev, Fourier, Legendre
from sailnet.ocp.solvers.delta.solver import solve

__all__ = [
    "Basis",
    "Chebyshev",
    "CmaEs",
    "Fourier",
    "GaPso",
    "Heuristic",
    "Imperialist",
    "Legendre",
    "Options",
    "Polish",
    "RandomSeries",
    "Weights",
    "solve",
]
