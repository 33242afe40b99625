"""Pontryagin networks by the (extreme) theory of functional connections. Papers 000 and 002.

smooth = ponn.solve(problem, ponn.RandomWeights(0.01), options=ponn.Options(schedule=Schedule(1.0, 0.1)))
limit = ponn.split.solve(problem, smooth)
"""

from sailnet.ocp.solvers.ponn import split
from sailnet.ocp.solvers.ponn.bases import Basis, Chebyshev, RandomFeatures
from sailnet.ocp.solvers.ponn.solver import Options, RandomWeights, solve

__all__ = ["Basis", "Chebyshev", "Options", "RandomFeatures", "RandomWeights", "solve", "split"]
