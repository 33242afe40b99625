"""The ``sailnet`` command."""

import argparse
import json
import math
import sys
from collections.abc import Callable, Sequence
from contextlib import nullcontext
from pathlib import Path
from typing import TYPE_CHECKING, Literal

from tqdm import tqdm

from sailnet import __version__, tested_range
from sailnet.disturbances import Disturbance, catalogue, disturbance_from
from sailnet.errors import SailnetError, SolveError
from sailnet.mission import Mission, load_mission
from sailnet.optics import OPTICS

if TYPE_CHECKING:
    from sailnet.expert import Extremal
    from sailnet.flight import History

Result = dict[str, object]


def main(arguments: Sequence[str] | None = None) -> int:
    """Run the command line; returns the exit status: 0, or 1 when something cannot be done or is wrong."""
    given = sys.argv[1:] if arguments is None else list(arguments)
    options = _parser().parse_args([_shield(argument) for argument in given])
    run: Callable[[argparse.Namespace], Result | int] = options.run
    try:
        result = run(options)
    except SailnetError as error:
        print(f"error: {error}", file=sys.stderr)
        return 1
    except KeyboardInterrupt:
        print("interrupted", file=sys.stderr)
        return 130
    if isinstance(result, int):
        return result  # The command has printed what it found.
    if options.json:
        print(json.dumps(result))
    else:
        print("\n".join(f"{key:28s} {_readable(value)}" for key, value in result.items()))
    return 0


def _shield(argument: str) -> str:
    """Keep argparse from taking -1e-3 or -inf for an option: it looks at the first character."""
    try:
        float(argument)
    except ValueError:
        return argument
    return f" {argument}" if argument.startswith("-") else argument


def _readable(value: object) -> str:
    if isinstance(value, float):
        return f"{value:.8g}"
    if isinstance(value, (list, tuple)):
        return "  ".join(_readable(item) for item in value)
    if isinstance(value, dict):
        return "\n".join([""] + [f"    {key:20s} {_readable(item)}" for key, item in value.items()])
    return str(value)


def _parser() -> argparse.ArgumentParser:
    parser = argparse.ArgumentParser(
        prog="sailnet",
        description="Optimal guidance of a solar sail: expert, networks, onboard C, closed loop.",
        epilog="R in AU, U and V in AU/TU (a circular orbit at 1 AU has speed 1); angles in radians.",
    )
    parser.add_argument("--version", action="version", version=f"sailnet {__version__}")
    commands = parser.add_subparsers(title="commands", required=True, metavar="COMMAND")

    common = argparse.ArgumentParser(add_help=False)
    common.add_argument("--mission", default="earth_mars", help="mission name or TOML file (%(default)s)")
    common.add_argument("--json", action="store_true", help="print one JSON object and nothing else")

    state, perhaps_state = _state_parser(), _state_parser("?")

    backend = argparse.ArgumentParser(add_help=False)
    backend.add_argument("--backend", choices=("c", "onnx"), default="c", help="what runs the networks")
    backend.add_argument("--precision", choices=("float64", "float32"), default="float64")
    backend.add_argument("--networks", type=Path, metavar="DIR", help="exported networks (default: shipped)")

    loop = _loop_parser()

    def command(
        name: str,
        run: Callable[[argparse.Namespace], Result],
        help_: str,
        *parents: argparse.ArgumentParser,
        example: str,
    ) -> argparse.ArgumentParser:
        made = commands.add_parser(
            name, parents=[*parents, common], help=help_, description=help_, epilog=f"example: {example}"
        )
        made.set_defaults(run=run)
        return made

    command(
        "solve",
        _solve,
        "The indirect optimum from a state; without one, the nominal from the mission's departure orbit.",
        perhaps_state,
        _override_parser(),
        example="sailnet solve 1 0 1; sailnet solve --mission earth_venus; "
        "sailnet solve --phi-max 45 --beta 0.25 --target-radius 0.9 --smoothing 0",
    )
    guide = command(
        "guide",
        _guide,
        "One guidance command from the networks.",
        state,
        backend,
        example="sailnet guide 1.05 0.15 1.03 --beta 0.15 --json",
    )
    guide.add_argument("--beta", type=float, metavar="X", help="the sail's real one (default: the mission's)")
    command(
        "fly",
        _fly,
        "One closed-loop flight.",
        state,
        backend,
        loop,
        example="sailnet fly 1.1 0.18 0.93 --beta-noise 0.15 --seed 3 --plot flight.html",
    ).add_argument("--plot", type=Path, metavar="FILE", help="show the flight: FILE.png or FILE.html")
    evaluate = command(
        "evaluate",
        _evaluate,
        "Closed-loop flights from random starts of the generalisation set, or a whole campaign.",
        backend,
        loop,
        example="sailnet evaluate --flights 1000 --beta-noise 0.15 --rate-limit 5 --optics jpl; "
        "sailnet evaluate --campaign everything --workers 2",
    )
    evaluate.add_argument(
        "--campaign",
        metavar="NAME",
        help="a ready campaign or a TOML file; its results and its report are written to --output",
    )
    evaluate.add_argument(
        "--output", type=Path, default=Path("campaigns"), metavar="DIR", help="(%(default)s)"
    )
    evaluate.add_argument("--restart", action="store_true", help="throw away what was flown before")
    evaluate.add_argument(
        "--overwrite",
        action="store_true",
        help="replace a finished campaign of the same name, but another mission, file, networks or options",
    )
    evaluate.add_argument(
        "--flights", type=int, metavar="N", help="how many (100, or what the campaign says for random starts)"
    )
    evaluate.add_argument("--workers", type=int, default=1, metavar="N", help="processes (%(default)s)")
    evaluate.add_argument("--scheduler", metavar="ADDRESS", help="Dask scheduler whose workers fly instead")

    about = "Verify a data set (checksums, ranges, optimality) and summarise it."
    example = "example: sailnet info build/earth_mars/domain.h5"
    info = commands.add_parser("info", help=about, description=about, epilog=example)
    info.add_argument("file", metavar="FILE", type=Path, help="the HDF5 file")
    info.add_argument("--json", action="store_true", help="print one JSON object and nothing else")
    info.set_defaults(run=_info)

    about = "What four papers print, beside ours and a second method's; minutes."
    example = (
        "example: sailnet papers 003; sailnet papers sail --output pictures; sailnet papers goddard --json"
    )
    papers = commands.add_parser("papers", help=about, description=about, epilog=example)
    papers.add_argument("name", metavar="NAME", nargs="?", help="number of a paper or a problem (all)")
    papers.add_argument("--json", action="store_true", help="print one JSON list and nothing else")
    papers.add_argument(
        "--output", metavar="DIR", type=Path, help="write papers.json, papers.md, a page and pictures there"
    )
    papers.add_argument("--readme", metavar="FILE", type=Path, help="fill its blocks `papers` and `sail`")
    papers.set_defaults(run=_papers)
    return parser


def _state_parser(nargs: Literal["?"] | None = None) -> argparse.ArgumentParser:
    parser = argparse.ArgumentParser(add_help=False)
    parser.add_argument("r", metavar="R", type=float, nargs=nargs, help="distance from the Sun [AU]")
    parser.add_argument("u", metavar="U", type=float, nargs=nargs, help="radial speed [AU/TU]")
    parser.add_argument("v", metavar="V", type=float, nargs=nargs, help="transverse speed [AU/TU]")
    return parser


def _override_parser() -> argparse.ArgumentParser:
    parser = argparse.ArgumentParser(add_help=False)
    group = parser.add_argument_group("instead of the mission's own")
    for option, metavar, meaning, (low, high) in (
        ("--phi-max", "DEG", "bound on the cone angle, 90 for none", tested_range.CONE_ANGLE),
        ("--beta", "X", "normalised characteristic acceleration", tested_range.BETA),
        ("--target-radius", "AU", "radius of the target orbit", tested_range.TARGET_RADIUS),
        ("--smoothing", "X", "delta of Eq. (12), 0 for the exact law", tested_range.SMOOTHING),
    ):
        help_ = f"{meaning} (tested: {low:g} to {high:g})"
        group.add_argument(option, type=float, metavar=metavar, help=help_)
    return parser


def _loop_parser() -> argparse.ArgumentParser:
    parser = argparse.ArgumentParser(add_help=False)
    parser.add_argument("--period", type=float, metavar="TU", help="guidance period (default: the mission's)")
    parser.add_argument("--seed", type=int, help="of every random number (default: the mission's, or 0)")
    group = parser.add_argument_group(
        "disturbances", "All are off unless given here or in the mission file's table [disturbance]."
    )
    for quantity in catalogue():
        option, meaning = f"--{quantity.name.replace('_', '-')}", quantity.meaning
        if quantity.name == "optics":
            group.add_argument(option, choices=tuple(OPTICS), help="optical coefficients of the sail")
        else:
            unit = "X" if quantity.unit == "1" else quantity.unit
            default = f" (otherwise {quantity.default:g})" if quantity.default else ""
            group.add_argument(option, type=float, metavar=unit, help=meaning + default)
    return parser


def _solve(options: argparse.Namespace) -> Result:
    from sailnet.expert import solve
    from sailnet.nominal import solve_nominal

    mission = load_mission(options.mission).with_overrides(
        beta=options.beta,
        max_cone_angle=options.phi_max,
        smoothing=options.smoothing,
        target_radius=options.target_radius,
    )
    given = [x is not None for x in (options.r, options.u, options.v)]
    if any(given) and not all(given):
        raise SailnetError("give all of R U V, or none of them to start from the mission's departure orbit")
    state = _state(options) if all(given) else None
    for remark in tested_range.beyond(mission.problem):
        print(f"note: {remark}", file=sys.stderr)
    if state:
        return _facts(solve(mission.problem, state))
    nominal = solve_nominal(mission)
    return {
        "state": nominal.smoothed.state.tolist(),
        **_facts(nominal.smoothed),
        "unconstrained_time_of_flight": nominal.unconstrained.time_of_flight,
        "constrained_time_of_flight": nominal.constrained.time_of_flight,
    }


def _facts(extremal: "Extremal") -> Result:
    return {
        "time_of_flight": extremal.time_of_flight,
        "cone_angle": extremal.cone_angle,
        "costates": extremal.costates.tolist(),
        "jumps": extremal.jumps,
        "residual": extremal.residual,
        "next_time_of_flight": None if math.isnan(extremal.rival_time) else extremal.rival_time,
    }


def _guide(options: argparse.Namespace) -> Result:
    from sailnet.backends import load_guidance
    from sailnet.guidance import GuidanceStatus

    state = _state(options)
    guidance = load_guidance(
        load_mission(options.mission), options.backend, options.precision, options.networks
    )
    low, high = guidance.beta_range
    if options.beta is not None and not low <= options.beta <= high:
        raise SailnetError(f"the networks know sails with beta from {low:g} to {high:g}, not {options.beta}")
    command = guidance.command([state], options.beta)
    return {
        "cone_angle": float(command.cone_angle[0]),
        "time_of_flight": float(command.time_of_flight[0]),
        "status": GuidanceStatus(command.status[0]).name.lower(),
    }


def _fly(options: argparse.Namespace) -> Result:
    from sailnet.backends import load_guidance
    from sailnet.expert import solve
    from sailnet.flight import Ending, fly
    from sailnet.report import need_pictures, report

    mission = load_mission(options.mission)
    state = _state(options)
    if options.plot is not None and options.plot.suffix not in (".png", ".html"):
        raise SailnetError(f"--plot writes FILE.png or FILE.html, not {options.plot}")
    if options.plot is not None:
        need_pictures()
    guidance = load_guidance(mission, options.backend, options.precision, options.networks)
    disturbance = _disturbance(options, mission)
    recorder: list[History] | None = None if options.plot is None else []
    flight = fly(
        mission, guidance, [state], disturbance=disturbance, period=options.period, recorder=recorder
    )
    try:
        optimum: Extremal | None = solve(mission.problem, state)
    except SolveError as error:
        print(f"note: {error}", file=sys.stderr)
        optimum = None
    result: Result = {
        "arrived": bool(flight.arrived[0]),
        "ending": Ending(flight.ending[0]).name.lower(),
        "time_of_flight": float(flight.time_of_flight[0]),
        "terminal_error": flight.terminal_error[0].tolist(),
        "nearest_error": float(flight.nearest_error[0]),
        "max_cone_angle": float(flight.max_cone_angle[0]),
        "beta_error": float(flight.beta_error[0]),
        "beta_estimate": float(flight.beta_estimate[0]),
        "optimal_time_of_flight": None if optimum is None else optimum.time_of_flight,
    }
    if recorder is not None:
        facts = {key.replace("_", " "): _readable(value) for key, value in result.items()}
        report("flight_page").plot_flight(options.plot, mission, recorder[0], optimum, facts)
        result["plot"] = str(options.plot)
    return result


def _evaluate(options: argparse.Namespace) -> Result:
    if options.campaign is not None:
        from sailnet.campaign_command import evaluate_campaign

        return evaluate_campaign(options)
    from sailnet.backends import load_guidance
    from sailnet.campaign.random_flights import fly_random_starts
    from sailnet.campaign.scores import Share, attitude_violations, component_quantiles
    from sailnet.executors import workers

    mission = load_mission(options.mission)
    guidance = load_guidance(mission, options.backend, options.precision, options.networks)
    disturbance = _disturbance(options, mission)
    alone = options.workers == 1 and options.scheduler is None
    with nullcontext() if alone else workers(options.workers, options.scheduler) as pool:
        count = 100 if options.flights is None else options.flights
        flights = fly_random_starts(
            mission, guidance, count, disturbance, period=options.period, workers=pool
        )
    arrived = Share.where(flights.arrived)
    quantiles = component_quantiles(flights, (0.5, 0.9, 0.95, 0.99, 1.0))
    return {
        "flights": arrived.of,
        "arrived": arrived.count,
        "success_share": arrived.share,
        "confidence_interval": list(arrived.interval),
        "error_quantiles": {f"{level:g}": values for level, values in quantiles.items()},
        "attitude_violations": attitude_violations(flights, mission.problem.phi_max),
    }


def _disturbance(options: argparse.Namespace, mission: Mission) -> Disturbance:
    names = ["seed", *(quantity.name for quantity in catalogue())]
    given = {name: getattr(options, name) for name in names}
    return disturbance_from(
        {name: value for name, value in given.items() if value is not None}, mission.disturbance
    )


def _info(options: argparse.Namespace) -> Result:
    from sailnet.inspection import inspect_dataset

    # Shown where it takes longer than two seconds.
    with tqdm(desc="verify", unit="value", unit_scale=True, delay=2.0, file=sys.stderr, disable=None) as bar:
        return inspect_dataset(options.file, bar)


def _papers(options: argparse.Namespace) -> int:
    from sailnet.ocp.papers import command

    return command.run(options.name, options.json, options.output, options.readme)


def _state(options: argparse.Namespace) -> tuple[float, float, float]:
    state = (options.r, options.u, options.v)
    if not all(math.isfinite(x) for x in state) or not options.r > 0.0:
        raise SailnetError(f"the state R U V must be three finite numbers with R > 0, not {state}")
    return state


if __name__ == "__main__":
    sys.exit(main())
