"""``python -m export.ship``: make a finished run the networks that come with the package.

Copies the weights, exports them into the package, and writes their model card and the README's table
from the files of the run: no figure is typed by hand.
"""

import argparse
import json
import shutil
import sys
from collections.abc import Mapping
from functools import partial
from pathlib import Path

from export.errors import ExportError
from export.write import export
from sailnet import SailnetError, load_mission
from sailnet.files import write_whole
from sailnet.mission import Mission
from sailnet.networks import Network, load_network

TRIO = ("tau", "alpha_pre", "lambda_v")
OPENING, CLOSING = "<!-- results -->", "<!-- /results -->"


def _table(report: Mapping[str, object]) -> str:
    rows = report["rows"]
    assert isinstance(rows, list)
    lines = ["| quantity | paper | here | |", "|---|---|---|---|"]
    for row in rows:
        cells = [str(row[key]).replace("|", "&#124;") for key in ("quantity", "paper", "here", "note")]
        lines.append("| " + " | ".join(cells) + " |")
    return "\n".join(lines)


def _made(report: Mapping[str, object]) -> str:
    software = report["software"]
    assert isinstance(software, dict)
    return (
        f"Written by `make ship` from a run of `make` on {software['machine']}, {software['date']}, "
        f"revision {software['revision']}, seed {report['seed']}."
    )


def model_card(mission: Mission, networks: Mapping[str, Network], report: Mapping[str, object]) -> str:
    """Markdown: what the networks are, what they were trained on, what they do and do not do."""
    lines = [
        f"# Model card: {mission.title}",
        "",
        _made(report),
        "",
        "| network | predicts | inputs | hidden | parameters | test MSE | epochs | seed |",
        "|---|---|---|---|---|---|---|---|",
    ]
    for name, network in networks.items():
        record = network.provenance
        count = sum(w.size for w in network.weights) + sum(b.size for b in network.biases)
        predicts = str(record["definition"]).replace("|", "&#124;")
        lines.append(
            f"| {name} | {predicts} | {', '.join(network.inputs)} | {'-'.join(map(str, network.hidden))} "
            f"| {count} | {record['test_mse']:.2e} | {record['epochs']} | {record['seed']} |"
        )
    tau = networks["tau"]
    domain = ", ".join(
        f"{name} in [{low:.4f}, {high:.4f}]"
        for name, low, high in zip(tau.inputs, tau.input_min, tau.input_max, strict=True)
    )
    lines += [
        "",
        f"Data set: SHA-256 `{tau.provenance['dataset']}`, split {tau.provenance['split']}. Test errors are "
        f"over {tau.provenance['test_samples']} samples of trajectories that took no part in training, "
        "scaled to [0, 1].",
        "",
        f"**Domain.** Trained on states with {domain} [AU, AU/TU], which is a box around the data, not the "
        "data: states inside it may lie far from every sample. Outside, the command stays within the bound "
        "and the status says so; it is not to be trusted.",
        "",
        "**Limits.** Planar circular target orbit, ideal sail, nominal characteristic acceleration. "
        "The share of random starts that do not arrive is in the table.",
        "",
        _table(report),
        "",
    ]
    return "\n".join(lines)


def ship(build: Path, package: Path, mission: Mission, readme: Path | None) -> None:
    """Fill ``package`` from the run in ``build``, and the README's results if it is given.

    Raises:
        ExportError: the run is incomplete.
    """
    try:
        report = json.loads((build / "report" / "report.json").read_text(encoding="utf-8"))
    except (OSError, ValueError) as error:
        raise ExportError(f"{build} holds no finished run: {error}; run make first") from error
    folder = build / "networks"
    networks = {name: load_network(folder / f"{name}.safetensors") for name in TRIO}
    export(folder, package, mission)
    for name in TRIO:
        source = folder / f"{name}.safetensors"
        write_whole(package / source.name, partial(shutil.copyfile, source))
    card = model_card(mission, networks, report)
    write_whole(package / "MODEL_CARD.md", lambda beside: beside.write_text(card, encoding="utf-8"))
    if readme is not None:
        before, rest = readme.read_text(encoding="utf-8").split(OPENING)
        after = rest.split(CLOSING)[1]
        text = f"{before}{OPENING}\n## Results\n\n{_made(report)}\n\n{_table(report)}\n{CLOSING}{after}"
        write_whole(readme, lambda beside: beside.write_text(text, encoding="utf-8"))


def main() -> int:
    """Run the command; returns its exit status."""
    parser = argparse.ArgumentParser(
        prog="python -m export.ship",
        description=__doc__,
        epilog="example: python -m export.ship build/earth_mars sailnet/shipped/earth_mars",
        formatter_class=argparse.RawDescriptionHelpFormatter,
    )
    parser.add_argument("build", type=Path, help="folder of a finished run")
    parser.add_argument("package", type=Path, help="folder in the package")
    parser.add_argument("--mission", default="earth_mars", help="mission name or TOML file (%(default)s)")
    parser.add_argument("--readme", type=Path, help="also write the results into this file")
    options = parser.parse_args()
    try:
        ship(options.build, options.package, load_mission(options.mission), options.readme)
    except (SailnetError, OSError) as error:
        print(f"error: {error}", file=sys.stderr)
        return 1
    return 0


if __name__ == "__main__":
    sys.exit(main())
