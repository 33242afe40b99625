"""The guidance law as a PyTorch module, of the form and the dimensions that the networks have."""

from export.torch_in_space import TorchGuidanceInSpace
from export.torch_networks import TorchApproachGuidance, TorchGuidance, TorchPaperGuidance
from sailnet.guidance.facts import GuidanceFacts
from sailnet.networks.guidance_in_space import AnyGuidanceNetworks, GuidanceNetworksInSpace


def torch_guidance(networks: AnyGuidanceNetworks, facts: GuidanceFacts) -> TorchGuidance:
    """What these networks command."""
    if isinstance(networks, GuidanceNetworksInSpace):
        return TorchGuidanceInSpace(networks, facts)
    return TorchApproachGuidance(networks, facts) if networks.approach else TorchPaperGuidance(networks)
