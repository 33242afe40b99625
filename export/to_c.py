"""The C file and its header, composed of the hand-written sources in ``c_runtime`` and the weights."""

import math
import re
from collections.abc import Sequence
from pathlib import Path

import numpy as np

from export.compact_tables import compact_tables
from export.domain import domain_tables
from export.tables import LOG2_E, constants, literal, stage_tables
from sailnet.guidance_facts import GuidanceFacts, round_down
from sailnet.networks import GuidanceNetworks, Network
from sailnet.steering import LARGEST_SURPRISE, LEAST_COSINE2, MEMORY

C_RUNTIME = Path(__file__).parent.parent / "c_runtime"


def write_c(networks: GuidanceNetworks, facts: GuidanceFacts, folder: Path) -> None:
    """Write ``sailnet_guidance.c`` and ``.h``, and the batch entry that simulation adds to them.

    Raises:
        ExportError: a weight does not fit single precision.
    """
    (folder / "sailnet_guidance.h").write_text(_header(facts, networks.approach))
    (folder / "sailnet_guidance.c").write_text(_source(networks, facts))
    for part in ("simulation/sailnet_batch.h", "simulation/sailnet_batch.c"):
        (folder / Path(part).name).write_text(_read(part))


def _header(facts: GuidanceFacts, reads_beta: bool) -> str:
    text = _read("flight/sailnet_guidance.h.in")
    r, u, v = facts.target_state
    for key, value in {
        "PROVENANCE": _provenance(facts),
        "VERSION": facts.version,
        "MISSION": facts.mission,
        "MISSION_DIGEST": facts.mission_digest,
        "NETWORKS_DIGEST": facts.networks_digest,
        "PHI_MAX_FLOAT32": literal(round_down(facts.phi_max, np.float32)),
        "PHI_MAX_FLOAT64": literal(facts.phi_max),
        "ARRIVAL_THRESHOLD": literal(facts.arrival_threshold),
        "ARRIVAL_TOLERANCE": literal(facts.arrival_tolerance),
        "TARGET_R": literal(r),
        "TARGET_U": literal(u),
        "TARGET_V": literal(v),
        "LARGEST_TIME_OF_FLIGHT": literal(facts.largest_time_of_flight),
        "READS_BETA": str(int(reads_beta)),
        "BETA": literal(facts.beta),
        "BETA_MIN": literal(facts.beta_min),
        "BETA_MAX": literal(facts.beta_max),
        "MEMORY": literal(MEMORY),
        "LARGEST_SURPRISE": literal(LARGEST_SURPRISE),
        "LEAST_COSINE2": literal(LEAST_COSINE2),
    }.items():
        text = text.replace(f"@{key}@", value)
    return text


def _source(networks: GuidanceNetworks, facts: GuidanceFacts) -> str:
    title = "Neural optimal guidance of a solar sail: see sailnet_guidance.h."
    opening = f"/*\n * {title}\n *\n{_provenance(facts)}\n */\n"
    trio = [networks.tau, networks.alpha_pre, networks.lambda_v]
    if networks.approach:
        # tau comes as a power of 2.
        stages = [
            *_on_vectors_or_not("simulation/host/exp2", "simulation/host/first_lane"),
            _stage("approach", trio, (LOG2_E, 1.0, 1.0), (4, 3, 2, 1, 0)),
            _read("simulation/host/networks_approach.inc"),
        ]
        compact = ["network", "power_of_two", "law", "cosine_sine"]
    else:
        stages = [
            _stage("tau", trio[:1]),
            _stage("command", trio[1:]),
            _read("simulation/host/networks_paper.inc"),
        ]
        compact = ["network", "law", "cosine_sine"]
    edge_on = math.cos(facts.phi_max) ** 2 < LEAST_COSINE2
    return "\n".join(
        [
            opening + _read("flight/arithmetic.inc"),
            "#ifdef SAILNET_VECTORS",
            _read("simulation/host/vectors.inc"),
            "#endif",
            *_on_vectors_or_not("flight/sigmoid"),
            "#ifdef SAILNET_COMPACT",
            compact_tables(networks, facts),
            "#endif",
            _read("flight/bounds.inc"),
            "#ifdef SAILNET_COMPACT",
            *(_read(f"flight/{part}.inc") for part in compact),
            "#else",
            _read("simulation/host/lanes.inc"),
            constants(facts, networks.approach),
            _read("simulation/host/deviation.inc"),
            *stages,
            domain_tables(facts),
            *(_read(f"simulation/host/{part}.inc") for part in ("domain", "guidance", "law", "cosine_sine")),
            "#endif\n",
            f"#define SAILNET_MAY_BE_EDGE_ON {int(edge_on)}",
            _read("flight/steering.inc"),
        ]
    )


def _stage(
    name: str,
    networks: Sequence[Network],
    units: Sequence[float] | None = None,
    order: Sequence[int] | None = None,
) -> str:
    forms = (
        f"#if {name.upper()}_SIDE_BY_SIDE",
        _instance(_read("simulation/host/side_by_side.inc"), name),
        "#else",
        _instance(_read("simulation/host/stage.inc"), name),
        "#endif\n",
    )
    return "\n".join([stage_tables(name, networks, units, order), *forms])


def _instance(template: str, stage: str) -> str:
    named = template.replace('"stage"', f'"{stage}"').replace("sailnet_stage_", f"sailnet_{stage}_")
    return named.replace("STAGE_", f"{stage.upper()}_")


def _on_vectors_or_not(part: str, *of_vectors: str) -> list[str]:
    """A part that computes on vectors where there are any, and what is built on that."""
    source = _read(f"{part}.inc")
    on_vectors = [_over_lanes(source), *(_read(f"{name}.inc") for name in of_vectors)]
    return ["#ifdef SAILNET_VECTORS", *on_vectors, "#else", source, "#endif"]


def _over_lanes(source: str) -> str:
    """The same functions of each number in a vector."""
    named = re.sub(r"\bsailnet_(?=fraction|exp2_quotient|sigmoid|power|exp2)", "sailnet_lanes_", source)
    return named.replace("sailnet_real", "sailnet_lanes")


def _provenance(facts: GuidanceFacts) -> str:
    lines = [
        f"Exported by sailnet {facts.version} for mission {facts.mission}: do not edit.",
        f"mission   {facts.mission_digest}",
        f"networks  {facts.networks_digest}",
        *(f"data set  {digest} ({name})" for name, digest in facts.datasets.items()),
    ]
    # What a trainer recorded is free text: it must not end the comment.
    return "\n".join(" * " + line.replace("*/", "* /").replace("\n", " ") for line in lines)


def _read(part: str) -> str:
    return (C_RUNTIME / part).read_text(encoding="utf-8")
