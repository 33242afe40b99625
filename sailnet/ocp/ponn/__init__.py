"""Pontryagin networks by the (extreme) theory of functional connections. Papers 000 and 002."""

from sailnet.ocp.ponn.bases import Basis, Chebyshev, RandomFeatures

__all__ = ["Basis", "Chebyshev", "RandomFeatures"]
