"""The C file and its header, composed of the hand-written sources in ``c_runtime`` and the weights."""

from pathlib import Path

import numpy as np

from export.tables import domain_tables, literal, stage_tables
from sailnet.guidance_facts import GuidanceFacts, round_down
from sailnet.networks import GuidanceNetworks

C_RUNTIME = Path(__file__).parent.parent / "c_runtime"


def write_c(networks: GuidanceNetworks, facts: GuidanceFacts, folder: Path) -> None:
    """Write ``sailnet_guidance.c`` and ``.h``, and the batch entry that simulation adds to them.

    Raises:
        ExportError: a weight does not fit single precision.
    """
    (folder / "sailnet_guidance.h").write_text(_header(facts))
    (folder / "sailnet_guidance.c").write_text(_source(networks, facts))
    for part in ("include/sailnet_batch.h", "source/sailnet_batch.c"):
        (folder / Path(part).name).write_text(_read(part))


def _header(facts: GuidanceFacts) -> str:
    text = _read("include/sailnet_guidance.h.in")
    for key, value in {
        "PROVENANCE": _provenance(facts),
        "VERSION": facts.version,
        "MISSION": facts.mission,
        "MISSION_DIGEST": facts.mission_digest,
        "NETWORKS_DIGEST": facts.networks_digest,
        "PHI_MAX_FLOAT32": literal(round_down(facts.phi_max, np.float32)),
        "PHI_MAX_FLOAT64": literal(facts.phi_max),
        "ARRIVAL_THRESHOLD": literal(facts.arrival_threshold),
        "LARGEST_TIME_OF_FLIGHT": literal(facts.largest_time_of_flight),
    }.items():
        text = text.replace(f"@{key}@", value)
    return text


def _source(networks: GuidanceNetworks, facts: GuidanceFacts) -> str:
    title = "Neural optimal guidance of a solar sail: see sailnet_guidance.h."
    opening = f"/*\n * {title}\n *\n{_provenance(facts)}\n */\n"
    stage = _read("source/stage.c.in")
    return "\n".join(
        [
            opening + _read("source/arithmetic.c"),
            stage_tables("tau", [networks.tau]),
            _instance(stage, "tau"),
            stage_tables("command", [networks.alpha_pre, networks.lambda_v]),
            _instance(stage, "command"),
            domain_tables(facts.state_min, facts.state_max),
            _read("source/guidance.c"),
        ]
    )


def _instance(template: str, stage: str) -> str:
    named = template.replace('"stage"', f'"{stage}"').replace("sailnet_stage_", f"sailnet_{stage}_")
    return named.replace("STAGE_", f"{stage.upper()}_")


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
