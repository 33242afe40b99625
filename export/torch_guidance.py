"""The guidance law as a PyTorch module, of the form and the dimensions that the networks have."""

from export.torch_in_space import TorchGuidanceInSpace
from export.torch_networks import TorchApproachGuidance, TorchGuidance, TorchPaperGuidance
from sailnet.guidance.facts import GuidanceFacts
from sailnet.networks.guidance_in_space import AnyGuidanceNetworks, GuidanceNetworksInSpace
from sailnet.networks.plan_networks import PlanNetworks


def torch_guidance(
    networks: AnyGuidanceNetworks, facts: GuidanceFacts, plan: PlanNetworks | None = None
) -> TorchGuidance:
    """What these networks command.

    Args:
        networks: of the law.
        facts: of the mission.
        plan: networks of a first plan, if there are any; only beside networks in approach coordinates.
    """
    if isinstance(networks, GuidanceNetworksInSpace):
        return TorchGuidanceInSpace(networks, facts, plan)
    if networks.approach:
        return TorchApproachGuidance(networks, facts, plan)
    return TorchPaperGuidance(networks)
