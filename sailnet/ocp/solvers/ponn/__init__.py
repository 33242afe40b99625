"""Pontryagin networks by the (extreme) theory of functional connections. Papers 000 and 002.

smooth = ponn.solve(problem, HyperbolicTangent(), Schedule(1.0, 0.1), spread=0.01)
limit = ponn.split.solve(problem, smooth)
"""

from sailnet.ocp.solvers.ponn import split
from sailnet.ocp.solvers.ponn.bases import Basis, Chebyshev, RandomFeatures
from sailnet.ocp.solvers.ponn.solver import solve

__all__ = ["Basis", "Chebyshev", "RandomFeatures", "solve", "split"]
