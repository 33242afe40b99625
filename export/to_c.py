"""The C files and their header: the hand-written text in ``c_runtime``, the constants and the weights.

The order in which the text is put together is that of the templates: ``flight/sailnet_guidance.c.in`` and
``simulation/sailnet_guidance_host.c.in``.
"""

from collections.abc import Iterable, Sequence
from dataclasses import asdict
from pathlib import Path

import numpy as np

from export.domain import domain_tables
from export.errors import ExportError
from export.flight_tables import flight_tables
from export.host_tables import constants, stage_tables
from export.limits import ORDER, limits, scale_of_plan
from export.numbers import literal
from export.templates import filled
from sailnet.guidance.facts import GuidanceFacts, round_down
from sailnet.guidance.rules import LARGEST_PERIOD, RULES, SteeringRules
from sailnet.guidance.tracker.library import PROBLEM, known_plans, problem_of
from sailnet.networks.guidance_in_space import AnyGuidanceNetworks
from sailnet.networks.plan_networks import PlanNetworks
from sailnet.networks.steepness import LOG2_E
from sailnet.physics import units
from sailnet.physics.optics import Optics

SIMULATION = ("sailnet_batch.h", "sailnet_batch.c")
"""Files that are the same for all networks of as many dimensions, for simulation."""

TYPES = "sailnet_tracker_types.h"
"""Of the tracker, which the header has."""


def write_c(
    networks: AnyGuidanceNetworks,
    facts: GuidanceFacts,
    folder: Path,
    rules: SteeringRules = RULES,
    plan: PlanNetworks | None = None,
) -> None:
    """Write the flight file, its form for hosts, their header, and the batch entry that simulation adds.

    Args:
        networks: whose weights are written.
        facts: what flies by them.
        folder: where to.
        rules: of steering.
        plan: networks of a first plan; without them a plan comes from the ground alone.

    Raises:
        ExportError: a weight does not fit single precision, the networks do not fit each other, or the
            threshold of arrival is longer than steering holds a command.
    """
    if facts.arrival_threshold > LARGEST_PERIOD:
        raise ExportError(
            f"arrival_threshold is {facts.arrival_threshold:g} TU, and no guidance period is longer than "
            f"{LARGEST_PERIOD:g} TU: make it shorter"
        )
    (folder / "sailnet_guidance.h").write_text(_header(networks, facts, rules, plan))
    (folder / "sailnet_guidance.c").write_text(_flight(networks, facts, plan))
    (folder / "sailnet_guidance_host.c").write_text(_host(networks, facts, plan))
    for name in SIMULATION:
        (folder / name).write_text(filled(name, {}, in_space=facts.components > 3))


def _header(
    networks: AnyGuidanceNetworks, facts: GuidanceFacts, rules: SteeringRules, plan: PlanNetworks | None
) -> str:
    r, u, v = np.array(facts.target_state)[ORDER[facts.components]][:3]
    return filled(
        "sailnet_guidance.h.in",
        {
            "PROVENANCE": _provenance(facts),
            "IN_SPACE": str(int(facts.components > 3)),
            "PLANS": str(int(plan is not None)),
            "KNOWN_PLANS": str(len(facts.known_plans)),
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
            "READS_BETA": str(int(networks.approach)),
            **_sail(facts.optics),
            **_ageing(facts),
            "BETA": literal(facts.beta),
            "BETA_MIN": literal(facts.beta_min),
            "BETA_MAX": literal(facts.beta_max),
            **{name.upper(): literal(value) for name, value in asdict(rules).items()},
            "SLEW_RATE": literal(facts.turn_rate),
            "COSTATE_UNIT": literal(facts.costate_unit),
            "LARGEST_PERIOD": literal(LARGEST_PERIOD),
            "PERIOD_DAYS": _days(LARGEST_PERIOD),
            "RECKONING_DAYS": _days(rules.longest_reckoning),
            "AU": literal(units.AU),
            "TU": literal(units.TU),
            "AU_PER_TU": literal(units.AU_PER_TU),
            "GM_SUN": f"{units.GM_SUN:.12g}",
        },
        in_space=facts.components > 3,
    )


def _sail(optics: Optics) -> dict[str, str]:
    force = zip(("FORCE_SQUARE", "FORCE_LINEAR", "FORCE_ACROSS"), optics.force, strict=True)
    return {"SAIL": optics.description, **{key: literal(value) for key, value in force}}


def _ageing(facts: GuidanceFacts) -> dict[str, str]:
    known = facts.degradation
    return {
        "AGES": str(int(known.loss > 0.0)),
        "DEGRADATION_LOSS": literal(known.loss),
        "DEGRADATION_DOSE": literal(known.dose),
    }


def _parts(facts: GuidanceFacts) -> dict[str, str]:
    """The transfer as the tracker has it, and what only the C of a sail that ages has."""
    problem = problem_of(facts.optics, facts.phi_max, facts.beta, facts.target_state[0])
    rows = [
        f"    {literal(float(problem[name]))}, /* {name.replace('_', ' ')} */" for name in PROBLEM.names or ()
    ]
    return {
        "AGEING": '\n#include "ageing.inc"\n' if facts.degradation.loss > 0.0 else "",
        "PROBLEM": "\n".join(rows),
        "KNOWN_PLANS_TABLE": _known_plans(facts),
    }


def _known_plans(facts: GuidanceFacts) -> str:
    """Of each the state as the tracker has it, beta, the direction and the time to go."""
    rows = [
        f"    {{{{{_floats(plan['state'])}}}, {_floats([plan['beta']])}, "
        f"{{{_floats(plan['direction'])}}}, {_floats([plan['time_to_go']])}}},"
        for plan in known_plans(facts.known)
    ]
    table = ["const sailnet_known_plan sailnet_known_plans[SAILNET_KNOWN_PLANS] = {", *rows, "};"]
    none = ["static const sailnet_known_plan *const sailnet_known_plans = NULL;"]
    return "\n".join(["", "#ifndef SAILNET_LAW_ONLY", *(table if rows else none), "#endif", ""])


def _floats(values: Iterable[float]) -> str:
    return ", ".join(f"{np.float32(value)!s}f" for value in values)


def _days(time: float) -> str:
    return f"{time * units.TU / units.DAY:.0f}"


def _flight(networks: AnyGuidanceNetworks, facts: GuidanceFacts, plan: PlanNetworks | None) -> str:
    tables = flight_tables(networks, facts, plan)
    values = {"PROVENANCE": _provenance(facts), "TABLES": tables, **_parts(facts)}
    return filled("sailnet_guidance.c.in", values, in_space=facts.components > 3, without=[TYPES])


def _host(networks: AnyGuidanceNetworks, facts: GuidanceFacts, plan: PlanNetworks | None) -> str:
    flown = networks.all
    if networks.approach:
        # tau comes as a power of 2; the C gives those inputs first that are known first.
        order = range(len(networks.tau.inputs))[::-1]
        units = (LOG2_E, *[1.0] * (len(flown) - 1))
        approach = stage_tables("approach", flown, units, order)
        stages = {"FORM": "approach", "TABLES_OF_APPROACH": approach, **_stages_of_plan(plan, order)}
    else:
        stages = {
            "FORM": "paper",
            "TABLES_OF_TAU": stage_tables("tau", flown[:1]),
            "TABLES_OF_COMMAND": stage_tables("command", flown[1:]),
            "NETWORKS_OF_PLANS": "",
        }
    values = {
        "PROVENANCE": _provenance(facts),
        "LIMITS": limits(networks, facts),
        "CONSTANTS": constants(facts, networks.approach),
        "DOMAIN": domain_tables(facts),
        **_parts(facts),
    }
    return filled(
        "sailnet_guidance_host.c.in", values | stages, in_space=facts.components > 3, without=[TYPES]
    )


def _stages_of_plan(plan: PlanNetworks | None, order: Sequence[int]) -> dict[str, str]:
    """In space those of w come alone: of a stage only the last network has two outputs."""
    if plan is None:
        return {"NETWORKS_OF_PLANS": ""}
    flown = list(plan.all)
    tables = {"NETWORKS_OF_PLANS": '\n#include "networks_plan.inc"\n'}
    if len(flown) > 3:
        tables["TABLES_OF_PLAN_W"] = stage_tables("plan_w", [flown.pop()], order=order)
        flown.append(flown.pop(1))
    of_plan = f"{scale_of_plan()}\n{stage_tables('plan', flown, order=order)}"
    return {**tables, "TABLES_OF_PLAN": of_plan}


def _provenance(facts: GuidanceFacts) -> str:
    lines = [
        f"Exported by sailnet {facts.version} for mission {facts.mission}: do not edit.",
        f"mission   {facts.mission_digest}",
        f"networks  {facts.networks_digest}",
        *(f"data set  {digest} ({name})" for name, digest in facts.datasets.items()),
    ]
    # What a trainer recorded is free text: it must not end the comment.
    return "\n".join(" * " + line.replace("*/", "* /").replace("\n", " ") for line in lines)
