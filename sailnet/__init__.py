"""sailnet: from Pontryagin's principle to the flight computer."""

from sailnet.errors import SailnetError
from sailnet.mission import Mission, Transfer, load_mission

__version__ = "0.1.0"

__all__ = ["Mission", "SailnetError", "Transfer", "__version__", "load_mission"]
