"""``python -m export.find_rules``: search for the numbers of the thrust margin, over simulated flights.

Every candidate is a flight file of its own, compiled and flown over the series of a campaign, with a seed of
its own that no reported campaign uses. What is sought is the smallest mean, over the series, of the logarithm
of the mean time above the optimum of the sail that flew, plus 0.1 %: of all flights, so that what misses
its first approach counts with all it costs. Nelder and Mead's simplex, over the logarithms of the numbers.

A search can afford some hundred flights of a series, which see no chance of one in a hundred; misses of
the first approach are as rare, and dear. So what a search finds is tried again with ``--candidate``, over
thousands of flights.

Every candidate is written to the output as it is done, and is not flown again: a search that was stopped goes
on where it was.
"""

import argparse
import json
import sys
import tempfile
from collections.abc import Mapping, Sequence
from dataclasses import replace
from pathlib import Path

import numpy as np
from scipy.optimize import minimize
from tqdm import tqdm

from c_runtime.builds import BUILDS
from c_runtime.shared_library import CompilerError, compile_libraries
from export.errors import ExportError
from export.to_c import write_c
from sailnet import SailnetError, load_mission
from sailnet.campaign.excess import excess_of
from sailnet.campaign.own_optima import optimal_times_of
from sailnet.campaign.plan import Plan, Series, load_plan
from sailnet.campaign.scores import largest_error
from sailnet.flight.closed_loop import Flights, fly
from sailnet.guidance.exported_c import CGuidance
from sailnet.guidance.facts import describe
from sailnet.guidance.rules import RULES, SteeringRules
from sailnet.mission.mission import Mission
from sailnet.networks.guidance_in_space import AnyGuidanceNetworks, load_networks_of
from sailnet.networks.network import load_network
from sailnet.networks.plan_networks import PlanNetworks, load_plan_networks
from sailnet.physics.arrays import Array
from sailnet.workers.interruption import run_command

SOUGHT = (
    "memory",
    "surprise_memory",
    "tangential_loss",
    "reserve_slow",
    "reserve_white",
    "largest_reserve",
    "let_go",
)
"""Numbers of ``SteeringRules`` that are searched."""

FLOWN = BUILDS["f64"]
"""The flight file, in double precision."""

FLOOR = 1e-3
"""Added to a mean time above the optimum before its logarithm: a series that costs nothing is no goal."""

FIRST_STEP = 0.2
"""Of the simplex, relative."""

Record = dict[str, object]


class Trials:
    """Candidates flown over the series of a campaign.

    Args:
        mission: what is flown.
        networks: what flies.
        plan: the campaign.
        output: one line of JSON a candidate; those that it holds are not flown again.
        names: of the series that are flown; all by default.
        first_plans: networks of first plans, if there are any.

    Raises:
        ValueError: the campaign has no such series.
    """

    def __init__(
        self,
        mission: Mission,
        networks: AnyGuidanceNetworks,
        plan: Plan,
        output: Path,
        names: Sequence[str] | None = None,
        first_plans: PlanNetworks | None = None,
    ) -> None:
        self._first_plans = first_plans
        self._mission, self._networks, self._plan, self._output = mission, networks, plan, output
        self._series = [one for one in plan.whole if names is None or one.name in names]
        if unknown := set(names or ()) - {one.name for one in plan.whole}:
            known = "; ".join(one.name for one in plan.whole)
            raise ValueError(f"the campaign has no series {', '.join(sorted(unknown))}; it has: {known}")
        self._facts = describe(networks, mission, plan=first_plans)
        self._optima: dict[str, Array] = {}
        lines = output.read_text(encoding="utf-8").splitlines() if output.exists() else []
        self._known: dict[str, Record] = {
            json.dumps(record["rules"]): record for record in map(json.loads, lines)
        }

    def fly(self, rules: SteeringRules) -> Record:
        """What candidate rules amount to: ``score`` and, for each series, means, tails [deg] and shares."""
        numbers = {
            name: float(f"{value:.4g}")
            for name, value in vars(rules).items()
            if name in SOUGHT or value != getattr(RULES, name)
        }
        key = json.dumps(numbers)
        if key not in self._known:
            self._known[key] = self._flown(numbers)
            with self._output.open("a", encoding="utf-8") as file:
                file.write(json.dumps(self._known[key]) + "\n")
        return self._known[key]

    def _flown(self, numbers: Mapping[str, float]) -> Record:
        with tempfile.TemporaryDirectory() as name:
            folder = Path(name)
            rules = replace(RULES, **numbers)
            write_c(self._networks, self._facts, folder, rules, self._first_plans)
            compile_libraries(folder, folder, [FLOWN])
            guidance = CGuidance(self._mission, folder / FLOWN.library)
            series = {one.name: self._flights(guidance, one) for one in self._series}
        means = np.array([row["mean"] for row in series.values()])
        return {"score": float(np.log(means + FLOOR).mean()), "rules": dict(numbers), "series": series}

    def _flights(self, guidance: CGuidance, series: Series) -> dict[str, float]:
        mission, seed = self._mission, self._plan.seed
        starts = series.states(mission, guidance, seed, 0, series.count)
        disturbance = series.disturbances(mission, seed)
        flights = fly(mission, guidance, starts, disturbance=disturbance)
        if series.name not in self._optima:
            self._optima[series.name] = optimal_times_of(mission, flights, disturbance)
        return _row(mission, flights, self._optima[series.name])


def _row(mission: Mission, flights: Flights, optimal: Array) -> dict[str, float]:
    excess = excess_of(mission, flights, optimal)
    if excess is None:
        raise ExportError("no optimum is known of any flight: fly more")
    return {
        "mean": excess.relative.mean,
        "quantile_99": excess.relative.high,
        "first_approach": excess.first_approach.count / excess.first_approach.of,
        "reversals_99": float(np.quantile(flights.reversals, 0.99)),
        "slew_99": float(np.degrees(np.quantile(flights.command_slew, 0.99))),
        "within_1e-4": float((largest_error(flights) <= 1e-4).mean()),
    }


def candidate(text: str) -> SteeringRules:
    """Rules but for some numbers: ``reserve_white=4,let_go=0.1``; or for none.

    Raises:
        ValueError: not numbers of ``SteeringRules``.
    """
    pairs = [pair.partition("=")[::2] for pair in text.split(",") if pair]
    if unknown := sorted({name for name, _ in pairs} - set(vars(RULES))):
        known = ", ".join(vars(RULES))
        raise ValueError(f"the rules have no number {', '.join(unknown)}; these are: {known}")
    return replace(RULES, **{name: float(value) for name, value in pairs})


def search(trials: Trials, evaluations: int) -> Record:
    """The best candidate of a simplex search from the rules that fly now."""
    start = np.log([getattr(RULES, name) for name in SOUGHT])
    simplex = np.vstack([start, start + FIRST_STEP * np.eye(len(SOUGHT))])
    records: list[Record] = []
    with tqdm(total=evaluations, unit="candidate", file=sys.stderr, disable=None) as bar:

        def score(point: Array) -> float:
            rules = replace(RULES, **dict(zip(SOUGHT, np.exp(point).tolist(), strict=True)))
            records.append(trials.fly(rules))
            bar.update()
            bar.set_postfix_str(f"best {min(map(_score, records)):.3f}", refresh=False)
            return _score(records[-1])

        minimize(
            score,
            start,
            method="Nelder-Mead",
            options={"initial_simplex": simplex, "maxfev": evaluations, "adaptive": True, "xatol": 0.01},
        )
    return min(records, key=_score)


def _score(record: Record) -> float:
    return float(str(record["score"]))


def main(arguments: list[str] | None = None) -> int:
    """Run the command; returns its exit status."""
    parser = argparse.ArgumentParser(
        prog="python -m export.find_rules",
        description=__doc__,
        epilog="examples: python -m export.find_rules build/earth_mars/wide/networks build/rules.jsonl; "
        "python -m export.find_rules build/earth_mars/wide/networks build/tried.jsonl --flights 8000 "
        "--candidate reserve_white=2.7 --candidate reserve_white=4",
        formatter_class=argparse.RawDescriptionHelpFormatter,
    )
    parser.add_argument("networks", type=Path, help="folder of the weights")
    parser.add_argument("output", type=Path, help="a line of JSON for each candidate; what it holds is kept")
    parser.add_argument("--mission", help="name or TOML file (the name that the networks have)")
    parser.add_argument("--campaign", default="law", help="series to fly, by name or file (%(default)s)")
    parser.add_argument("--flights", type=int, default=400, help="of each series (%(default)s)")
    parser.add_argument("--seed", type=int, default=77, help="of starts and disturbances (%(default)s)")
    parser.add_argument("--evaluations", type=int, default=120, help="candidates (%(default)s)")
    parser.add_argument("--series", action="append", metavar="NAME", help="of the campaign; all by default")
    parser.add_argument(
        "--candidate",
        action="append",
        metavar="NAME=VALUE,...",
        help="fly the rules with these numbers changed, and do not search; '' for the rules as they are",
    )
    options = parser.parse_args(arguments)
    try:
        of = options.mission or load_network(options.networks / "tau.safetensors").mission.name
        mission = load_mission(of)
        networks = load_networks_of(mission, options.networks)
        plan = load_plan(options.campaign).flown_by(mission).changed(options.flights, options.seed)
        options.output.parent.mkdir(parents=True, exist_ok=True)
        first_plans = load_plan_networks(options.networks, mission)
        trials = Trials(mission, networks, plan, options.output, options.series, first_plans)
        if options.candidate is None:
            best = search(trials, options.evaluations)
        else:
            best = min((trials.fly(candidate(text)) for text in options.candidate), key=_score)
    except (SailnetError, CompilerError, OSError, ValueError) as error:
        print(f"export.find_rules: {error}", file=sys.stderr)
        return 1
    print(json.dumps(best, indent=1))
    return 0


if __name__ == "__main__":
    sys.exit(run_command(main, "the same command goes on with what it has written"))
