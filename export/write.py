"""One export: everything computed and checked beside the target folder, then moved into it."""

import tempfile
from collections.abc import Sequence
from dataclasses import replace
from pathlib import Path

from tqdm import tqdm

from c_runtime.builds import BUILDS
from c_runtime.shared_library import CompilerError, compile_libraries
from export.errors import ExportError
from export.to_c import write_c
from export.to_onnx import Graph, Inputs, write_onnx
from export.torch_guidance import torch_guidance
from export.torch_in_space import TorchGuidanceInSpace
from export.torch_networks import TorchBaseline
from sailnet.artefacts.checksums import write_checksums
from sailnet.artefacts.room import room_told
from sailnet.errors import NetworkError, reason
from sailnet.guidance.exported_files import graph_name
from sailnet.guidance.facts import GuidanceFacts, describe
from sailnet.guidance.rules import RULES, SteeringRules
from sailnet.mission.mission import Mission
from sailnet.networks.approach import APPROACH_INPUTS, APPROACH_INPUTS_IN_SPACE, LATERAL_INPUTS
from sailnet.networks.guidance_in_space import AnyGuidanceNetworks, GuidanceNetworksInSpace, load_networks_of
from sailnet.networks.guidance_networks import COMMAND_INPUTS, STATE_INPUTS
from sailnet.networks.network import Network, load_network
from sailnet.networks.plan_networks import PlanNetworks, load_plan_networks

CHECKSUMS = "SHA256SUMS"
UNFINISHED = ".export-"
STATE: Inputs = {"state": len(STATE_INPUTS)}
COMMAND = ("cone_angle", "time_of_flight", "lambda_v")
COMMAND_IN_SPACE = (*COMMAND, "clock_angle", "lambda_w")


def export(
    networks_folder: Path,
    target: Path,
    mission: Mission,
    baseline: Path | None = None,
    progress: bool = True,
    rules: SteeringRules | None = None,
    flight_only: bool = False,
    plans: bool = True,
) -> list[Path]:
    """Write ONNX graphs, C and compiled libraries of the networks in a folder; returns what was written.

    The list of checksums is moved last: an export that was killed between two files is noticed on load.

    Args:
        networks_folder: holds ``tau``, ``alpha_pre`` and ``lambda_v`` (``.safetensors``), in space also
            ``lambda_w``; and, for a first plan on board, the networks of the arrival costates.
        target: folder to write to; it keeps what it had if anything fails.
        mission: whose rules of flight are built in, and whose problem the networks must be trained for.
        baseline: ``alpha.safetensors``, a network that gives the signed cone angle from (r, u, v, tau); of
            the plane.
        progress: show a bar on stderr.
        rules: of steering, which the C has built in.
        flight_only: no ONNX graphs, and of the libraries the flight file in double precision alone: what a
            choice among networks flies.
        plans: with the networks of a first plan, where there are any.

    Raises:
        NetworkError: a network is missing, damaged or does not fit.
        ExportError: networks of another mission, no compiler, or a target that cannot be written.
    """
    networks = load_networks_of(mission, networks_folder)
    _refuse_other_mission(networks.tau, mission)
    alpha = load_network(baseline) if baseline else None
    if alpha is not None:
        _refuse_other_mission(alpha, mission)
        if alpha.inputs != COMMAND_INPUTS or networks.approach:
            raise NetworkError(
                f"a baseline takes {COMMAND_INPUTS} and flies with a tau of {STATE_INPUTS}, "
                f"not {alpha.inputs} with {networks.tau.inputs}"
            )
    rules = rules or RULES
    try:
        target.mkdir(parents=True, exist_ok=True)
        with tempfile.TemporaryDirectory(dir=target, prefix=UNFINISHED) as name, room_told(Path(name)):
            beside = Path(name)
            plan = load_plan_networks(networks_folder, mission) if plans else None
            facts = describe(networks, mission, plan=plan)
            write_c(networks, facts, beside, rules, plan)
            if flight_only:
                return _moved(beside, target, compile_libraries(beside, beside, [BUILDS["f64"]]))
            compiled = compile_libraries(beside, beside)
            # What steers has the known plans; a graph of one network does not.
            own = {graph_name("float32"): facts, graph_name("float64"): facts}
            alone = replace(facts, known_plans=())
            for graph in tqdm(_graphs(networks, facts, plan), "ONNX graphs", disable=not progress):
                write_onnx(graph, own.get(graph.file, alone), beside)
            if alpha is not None:
                pair = Graph("baseline_f64.onnx", TorchBaseline(networks.tau, alpha), STATE, COMMAND[:2])
                write_onnx(pair, describe(networks, mission, alpha), beside)
            return _moved(beside, target, compiled)
    except CompilerError as error:
        raise ExportError(str(error)) from error
    except OSError as error:
        raise ExportError(f"cannot write to {target}: {reason(error)}") from error


def _moved(beside: Path, target: Path, compiled: list[Path]) -> list[Path]:
    """Move what was written into the target, the list of checksums last."""
    listed = [file for file in beside.iterdir() if file not in compiled]
    write_checksums(listed, beside / CHECKSUMS)
    moved = [*sorted([*listed, *compiled]), beside / CHECKSUMS]
    return [file.replace(target / file.name) for file in moved]


def _graphs(
    networks: AnyGuidanceNetworks, facts: GuidanceFacts, plan: PlanNetworks | None = None
) -> list[Graph]:
    given = () if plan is None else ("arrival_direction",)
    if isinstance(networks, GuidanceNetworksInSpace):
        return _graphs_in_space(networks, TorchGuidanceInSpace(networks, facts, plan), given)
    guidance = torch_guidance(networks, facts, plan)
    whole: Inputs
    of_tau: Inputs
    of_command: Inputs
    if networks.approach:
        whole = {**STATE, "beta": None}
        of_tau = of_command = {"approach": len(APPROACH_INPUTS)}
    else:
        whole, of_tau, of_command = STATE, STATE, {"state_and_tau": len(COMMAND_INPUTS)}
    return [
        Graph("tau.onnx", guidance.tau, of_tau, ["tau"]),
        Graph("alpha_pre.onnx", guidance.alpha_pre, of_command, ["alpha_pre"]),
        Graph("lambda_v.onnx", guidance.lambda_v, of_command, ["lambda_v"]),
        Graph(graph_name("float32"), guidance.in_float32(), whole, (*COMMAND, *given)),
        Graph(graph_name("float64"), guidance, whole, (*COMMAND, *given)),
    ]


def _graphs_in_space(
    networks: GuidanceNetworksInSpace, guidance: TorchGuidanceInSpace, given: Sequence[str]
) -> list[Graph]:
    whole: Inputs = {"state": networks.components, "beta": None}
    even: Inputs = {"approach": len(APPROACH_INPUTS_IN_SPACE)}
    odd: Inputs = {**even, "lateral": len(LATERAL_INPUTS)}
    return [
        Graph("tau.onnx", guidance.tau, even, ["tau"]),
        Graph("alpha_pre.onnx", guidance.alpha_pre, even, ["alpha_pre"]),
        Graph("lambda_v.onnx", guidance.lambda_v, even, ["lambda_v"]),
        Graph("lambda_w.onnx", guidance.lambda_w, odd, ["lambda_w"]),
        Graph(graph_name("float32"), guidance.in_float32(), whole, (*COMMAND_IN_SPACE, *given)),
        Graph(graph_name("float64"), guidance, whole, (*COMMAND_IN_SPACE, *given)),
    ]


def _refuse_other_mission(network: Network, mission: Mission) -> None:
    trained = network.mission
    if trained.digest() != mission.digest():
        raise ExportError(
            f"network {network.name} was trained for mission {trained.name!r} with other parameters "
            f"than mission {mission.name!r} has now"
            f"{mission.another_sail(trained.sail.optics.description)}: "
            "train again, or name the mission with --mission"
        )
