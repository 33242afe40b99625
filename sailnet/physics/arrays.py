"""The one array type of the library: double precision."""

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]
"""Of any shape, unless the docstring says which."""
