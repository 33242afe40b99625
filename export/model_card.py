"""The model card of a set of networks, generated from the files of the run that made them."""

from collections.abc import Mapping, Sequence
from typing import Any

from sailnet.campaign.acceptance import acceptance_table
from sailnet.campaign.results import Results
from sailnet.networks.guidance_in_space import AnyGuidanceNetworks
from sailnet.networks.known_plans import KnownPlans
from sailnet.networks.network import Network
from sailnet.networks.plan_networks import PlanNetworks
from sailnet.physics.geometry import geometry_of
from sailnet.physics.optics import Optics

LIMITS = (
    "**Limits.** {orbits} Trained on flights of {sail}, whose state is known: "
    "what other optics, slow turning and errors of navigation cost is measured by the campaigns of the "
    "package, not trained for. Trained on the fastest extremals an indirect method finds; where two are "
    "equally fast the command is not smooth, and near there a flight may take the slower way. A drift of "
    "beta of one per cent a TU is beyond the networks: many flights miss. What they stand is below."
)

READING = (
    "Times are above the optimum for the true sail parameters, its constant beta and its optics, over all "
    "flights whose optimum is known, with the least time still to go where a flight was stopped short. "
    "The last column of the first table counts the others. A reversal is a step "
    "of the command of more than 40 degrees from one period to the next."
)

ORBITS = {
    3: "Planar circular target orbit.",
    5: "Circular target orbit, the departure's inclined to it; attitudes are not measured in flight.",
}
"""By the components of a state."""

UNITS = {3: "[AU, AU/TU]", 5: "[AU, rad, AU/TU]"}

Facts = Mapping[str, Any]
"""JSON that a command of the run left."""


def made_by(command: str, software: Facts, seed: int) -> str:
    """The line that says where figures come from."""
    return (
        f"Written by `make ship` from a run of `{command}` on {software['machine']}, {software['date']}, "
        f"revision {software['revision']}, seed {seed}."
    )


def accepted_by(acceptance: Results) -> str:
    """The line that says where the figures of an acceptance campaign come from."""
    return made_by("make accept", acceptance.provenance, acceptance.plan.seed)


def _networks_table(networks: Sequence[Network]) -> list[str]:
    lines = [
        "| network | predicts | inputs | hidden | parameters | test MSE | near arrival | epochs | seed |",
        "|---|---|---|---|---|---|---|---|---|",
    ]
    for network in networks:
        record = network.provenance
        count = sum(w.size for w in network.weights) + sum(b.size for b in network.biases)
        predicts = str(record["definition"]).replace("|", "&#124;")
        lines.append(
            f"| {network.name} | {predicts} | {', '.join(network.inputs)} "
            f"| {'-'.join(map(str, network.hidden))} "
            f"| {count} | {record['test_mse']:.2e} | {record['test_mse_near_arrival']:.2e} "
            f"| {record['epochs']} | {record['seed']} |"
        )
    return lines


def _of_plan(plan: PlanNetworks | None) -> list[str]:
    """What the networks of a first plan are for."""
    if plan is None:
        return ["No networks of a plan: the law of the networks flies unless a plan is uploaded.", ""]
    return [
        f"The last {len(plan.all)} begin a plan: they give the direction of the arrival costates of the "
        "optimal extremal, which Newton's method corrects in flight. Their errors decide how often that "
        "converges, and not how near to the optimum the vehicle flies.",
        "",
        _known(plan.known),
        "",
    ]


def _known(known: KnownPlans | None) -> str:
    if known is None:
        return "No known plans: where the plan of the networks leads nowhere, their law flies."
    record = known.provenance
    return (
        f"Known plans: {len(known)}, which are tried where no plan is flown and that of the networks leads "
        f"nowhere, as from {record['failed']:,} of {record['tried']:,} samples of training trajectories."
    )


def _begun(networks: Sequence[Network]) -> str:
    """Of networks that did not begin with random weights, with whose they did."""
    starts = {network.name: str(network.provenance.get("start", "")) for network in networks}
    told = [f"{name} with that of {start}" for name, start in starts.items() if "SHA-256" in start]
    return f"Training began: {'; '.join(told)}." if told else ""


def _choice(networks: Sequence[Network]) -> str:
    """How the networks were chosen among trainings, if they were."""
    record = networks[0].provenance.get("selection")
    if not isinstance(record, Mapping):
        return ""
    tried = ", ".join(
        f"{one['seed']} ({'passed' if one['passed'] else 'missed'})" for one in record["candidates"]
    )
    return (
        f"Training seeds tried: {tried}; chosen by {record['flights']:,} development flights of each series, "
        f"seed {record['seed']}: the first that met the acceptance criteria."
    )


def _domain(networks: AnyGuidanceNetworks) -> str:
    problem = networks.mission.problem
    size, (lowest, highest) = networks.components, networks.state_range
    box = ", ".join(
        f"{name} in [{low:.4f}, {high:.4f}]"
        for name, low, high in zip(geometry_of(size).state_names, lowest, highest, strict=True)
    )
    sails = (
        f"beta in [{networks.beta_range[0]:.5f}, {networks.beta_range[1]:.5f}] "
        f"(the mission's is {problem.beta:.5f})"
        if networks.approach
        else f"beta = {problem.beta:.5f}"
    )
    held_out = networks.tau.provenance.get("held_out_outside_domain")
    measured = f" {held_out:.3%} of the samples of held-out trajectories lie outside it." if held_out else ""
    return (
        f"**Domain.** Trained on states with {box} {UNITS[size]}, and on sails with {sails}. That box is "
        "mostly empty: the trained domain is a tube within it, by which the status is decided "
        f"(`sailnet/networks/trained_domain.py`).{measured} A state inside may still lie between "
        "samples. Outside the command stays within the bound and the status says so; it is not to be trusted."
    )


def _sail(optics: Optics) -> str:
    return "an ideal sail" if optics.ideal else f"a sail that is not ideal (optics: {optics.description})"


def _speed(timings: Facts) -> list[str]:
    lines = ["| a command | precision | median [ns] | minimum [ns] |", "|---|---|---|---|"]
    return lines + [
        f"| {line['what']} | {line['precision']} | {line['median_ns']:.0f} | {line['min_ns']:.0f} |"
        for line in timings["rows"]
    ]


def _agreement(records: list[Facts]) -> list[str]:
    lines = [
        "| attitudes, or directions, of | precision | states | largest [rad] | median [rad] |",
        "|---|---|---|---|---|",
    ]
    return lines + [
        f"| {record['pair']} | {record['precision']} | {record['count']:,} {record['states']} "
        f"| {record['largest']:.1e} | {record['median']:.0e} |"
        for record in records
    ]


def model_card(
    networks: AnyGuidanceNetworks,
    acceptance: Results,
    timings: Facts,
    agreement: list[Facts],
    plan: PlanNetworks | None = None,
) -> str:
    """Markdown: what the networks are, what they were trained on, what they do and do not do.

    Args:
        networks: of the law.
        acceptance: the campaign that they were accepted by.
        timings: of the benchmark.
        agreement: of :mod:`export.agreement`.
        plan: networks of a first plan, if there are any.
    """
    mission = networks.mission
    tau = networks.tau
    rules = acceptance.mission.flight  # by which they fly: those they were trained with may have been others
    return "\n".join(
        [
            f"# Model card: {mission.title}",
            "",
            accepted_by(acceptance),
            "",
            *_networks_table((*networks.all, *(() if plan is None else plan.all))),
            "",
            *_of_plan(plan),
            f"Data set: SHA-256 `{tau.provenance['dataset']}`, split {tau.provenance['split']}; made by "
            "`python -m data` from the mission's recipe. Test errors are over "
            f"{tau.provenance['test_samples']} samples of trajectories that took no part in training, scaled "
            "to [0, 1]; near arrival: those with less than 0.3 TU to go. Weights: SHA-256 "
            f"`{acceptance.networks}`. {_begun(networks.all)}".rstrip(),
            "",
            _choice(networks.all),
            "",
            _domain(networks),
            "",
            LIMITS.format(orbits=ORBITS[networks.components], sail=_sail(mission.sail.optics)),
            "",
            "## Closed loop",
            "",
            "The exported C from random starts of the generalisation set, guidance period "
            f"{rules.period:g} TU. Arrive: every component of the terminal error at most "
            f"{rules.arrival_tolerance:g} {UNITS[networks.components]}, no command out of bounds; in "
            f"brackets the 95 % interval. {READING} A flight that failed counts as "
            f"{rules.longest:g} TU, or its optimum if that is longer.",
            "",
            *acceptance_table(acceptance),
            "",
            "## Speed and arithmetic",
            "",
            *_speed(timings),
            "",
            *_agreement(agreement),
            "",
        ]
    )
