"""The table "paper | here"."""

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass

from sailnet.campaign import printed
from sailnet.campaign.shares import Share
from sailnet.dataset import Dataset
from sailnet.networks.network import Network
from sailnet.report.section5 import Flown, Section5


@dataclass(frozen=True)
class Row:
    """One line of the table; ``note`` says what a reader must know to compare the two."""

    quantity: str
    paper: str
    here: str
    note: str = ""


def _triple(values: Iterable[float]) -> str:
    return "(" + ", ".join(f"{value:.2e}" for value in values) + ")"


def comparison_lines(rows: Sequence[Row]) -> list[str]:
    """The table for a terminal."""
    width = max(len(row.quantity) for row in rows)
    return [f"{row.quantity:{width}s}  {row.paper or '-':38s}  {row.here}" for row in rows]


def problem_rows(data: Dataset) -> list[Row]:
    """Flight times of Section 4.1.1 and the size of the data set."""
    nominal = data.provenance.get("nominal", {})  # of the paper's recipe alone
    assert isinstance(nominal, dict)
    titles = {
        "unconstrained": "unconstrained",
        "constrained": "constrained, δ = 0",
        "smoothed": "constrained, δ = 1e-3 (nominal)",
    }
    rows = [
        Row(
            f"time of flight, {title} [TU]",
            f"{printed.TIMES[key]:.5f}",
            f"{nominal[key]['time_of_flight']:.5f}",
        )
        for key, title in titles.items()
        if key in nominal
    ]
    rows.append(Row("optimal trajectories", f"{printed.TRAJECTORIES:,}", f"{data.trajectories:,}"))
    rows.append(Row("samples", f"{printed.SAMPLES:,}", f"{data.samples:,}"))
    return rows


def error_rows(networks: Mapping[str, Network]) -> list[Row]:
    """Table 1: mean squared errors, scaled to [0, 1]."""
    errors = {
        **printed.ERRORS,
        "alpha_pre_eq23": printed.ERRORS["alpha_pre"],
        "lambda_v_printed": printed.ERRORS["lambda_v"],
    }
    titles = {
        "tau": "time of flight network",
        "lambda_v_printed": "λ_v network as printed",
        "lambda_v": "λ_v network that flies",
        "alpha_pre_eq23": "α_pre network, Eq. (23) as printed",
        "alpha_pre": "α_pre network that flies",
        "alpha": "α network, no preprocessing",
    }
    notes = {
        "lambda_v": "compressed target, asinh, which resolves the sign; in its own range",
        "alpha_pre_eq23": "this target is two-valued around the points where λ_u = λ_v = 0",
        "alpha_pre": "single-valued target, in its own range: four times stricter than Eq. (23)'s",
    }
    rows = []
    for name, title in titles.items():
        if name in networks:
            record = networks[name].provenance
            here = " / ".join(f"{record[f'{part}_mse']:.2e}" for part in ("train", "validation", "test"))
            theirs = " / ".join(f"{value:.2e}" for value in errors[name])
            rows.append(Row(f"MSE, {title}: training / validation / test", theirs, here, notes.get(name, "")))
    for name in ("alpha_pre_eq23", "alpha_pre", "alpha"):
        if name in networks:
            rows.append(
                Row(
                    f"test MSE of |α| from the {titles[name]}",
                    f"{errors[name][2]:.2e}" if name != "alpha_pre" else "",
                    f"{networks[name].provenance['command_mse']:.2e}",
                    "one measure for all targets: |α| over 2 φ_max, the same test trajectories",
                )
            )
    return rows


def flight_rows(section5: Section5, two: Mapping[str, Flown] | None = None) -> list[Row]:
    """Sections 5.1 to 5.3.

    Args:
        section5: by three networks.
        two: the cases by two networks, without preprocessing, if they were flown.
    """
    rows = []
    for name, flown in section5.cases.items():
        rows += _case_rows(name, flown)
        if two is not None:
            rows.append(
                Row(
                    f"{name}: ΔΦ, two networks",
                    _triple(printed.CASE_1_ERROR_TWO_NETWORKS) if name == "Case 1" else "",
                    _triple(two[name].error),
                    "" if two[name].flights.stopped[0] else "never met the stop rule",
                )
            )
    return rows + _noise_rows(section5.noise, section5.seed) + _random_start_rows(section5)


def _case_rows(name: str, flown: Flown) -> list[Row]:
    """A case of Section 5.1, with three networks."""
    return [
        Row(
            f"{name}: optimal time of flight [TU]",
            f"{printed.CASE_OPTIMUM[name]:.4f}",
            f"{flown.extremal.time_of_flight:.5f}",
            "indirect method",
        ),
        Row(
            f"{name}: time of flight predicted at departure [TU]",
            f"{printed.CASE_PREDICTED[name]:.4f}",
            f"{flown.history.predicted_time_of_flight[0]:.4f}",
        ),
        Row(
            f"{name}: time of flight flown, three networks [TU]",
            "",
            f"{flown.time_of_flight:.4f}",
            "the last command is held for the time predicted then",
        ),
        Row(f"{name}: ΔΦ, three networks", _triple(printed.CASE_ERROR[name]), _triple(flown.error)),
    ]


def _noise_rows(noise: Flown, seed: int) -> list[Row]:
    """The flight of Section 5.2."""
    return [
        Row(
            "β noise ±15 %: time of flight [TU]",
            f"{printed.NOISE_TIME:.4f}",
            f"{noise.time_of_flight:.4f}",
            f"optimum without noise {noise.extremal.time_of_flight:.4f}; the noise differs from the paper's",
        ),
        Row("β noise ±15 %: ΔΦ", _triple(printed.NOISE_ERROR), _triple(noise.error), f"seed {seed}"),
    ]


def _random_start_rows(section5: Section5) -> list[Row]:
    """The random starts of Section 5.3: as many as the paper's, and all that were flown."""
    flights, all_of_them = section5.random, Share.where(section5.more.arrived)
    rows = [
        Row(
            "random starts that arrive",
            f"{printed.GENERALISATION_SUCCESSES} of {printed.GENERALISATION_FLIGHTS}",
            f"{int(flights.arrived.sum())} of {len(flights.arrived)}",
            f"arrive: within 1e-3 in every component; seed {section5.seed}",
        )
    ]
    if flights.arrived.any():
        mean = flights.terminal_error[flights.arrived].mean(axis=0)
        rows.append(Row("their mean ΔΦ", _triple(printed.GENERALISATION_ERROR), _triple(mean)))
    low, high = all_of_them.interval
    rows.append(
        Row(
            "random starts that arrive, larger campaign",
            "",
            f"{all_of_them.count} of {all_of_them.of} = {100 * all_of_them.share:.1f} %",
            f"95 % interval {100 * low:.1f} to {100 * high:.1f} %",
        )
    )
    return rows


def timing_rows(timings: Mapping[str, object] | None) -> list[Row]:
    """Section 5.4: time of a command."""
    if timings is None:
        return []
    lines = timings["rows"]
    assert isinstance(lines, list)
    rows = []
    for line in lines:
        name, median, least = line["what"], float(line["median_ns"]), float(line["min_ns"])
        rows.append(
            Row(
                f"time of a command, {name}, {line['precision']} [µs]",
                f"{1e6 * printed.COMMAND_SECONDS:.1f}" if name == "exported C" else "",
                f"{median / 1e3:.3f}",
                f"median; minimum {least / 1e3:.3f}",
            )
        )
    return rows


def agreement_rows(records: Sequence[Mapping[str, object]] | None) -> list[Row]:
    """How far the back ends are apart, from ``python -m export.agreement``."""
    return [
        Row(
            f"|Δα| {record['pair']}, {record['precision']}, {record['states']} [rad]",
            "",
            f"{record['largest']:.1e}",
            f"largest of {record['count']:,} states; median {record['median']:.0e}; {_goal(record)}",
        )
        for record in records or []
    ]


def _goal(record: Mapping[str, object]) -> str:
    share = record["share_within_goal"]
    assert isinstance(share, float)
    return f"{100 * share:.2f} % within {'1e-12' if record['precision'] == 'float64' else '1e-6'}"
