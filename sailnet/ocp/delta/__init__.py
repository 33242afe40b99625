"""The delta method of paper 004: series for the controls, a heuristic for their coefficients.

solution = delta.solve(lunar_landing.problem(), basis=delta.Chebyshev(), heuristic=delta.Imperialist())
"""

from sailnet.ocp.delta.criteria import Weights
from sailnet.ocp.delta.heuristics import CmaEs, GaPso, Heuristic
from sailnet.ocp.delta.imperialist import Imperialist
from sailnet.ocp.delta.polish import Polish
from sailnet.ocp.delta.series import Basis, Chebyshev, Fourier, Legendre
from sailnet.ocp.delta.solver import solve

__all__ = [
    "Basis",
    "Chebyshev",
    "CmaEs",
    "Fourier",
    "GaPso",
    "Heuristic",
    "Imperialist",
    "Legendre",
    "Polish",
    "Weights",
    "solve",
]
