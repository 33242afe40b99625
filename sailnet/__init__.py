"""sailnet: from Pontryagin's principle to the flight computer."""

from sailnet.errors import SailnetError
from sailnet.mission.mission import Mission, load_mission
from sailnet.physics.transfer import Transfer

__version__ = "0.2.0"

__all__ = ["Mission", "SailnetError", "Transfer", "__version__", "load_mission"]
