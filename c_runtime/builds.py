"""Every build of the exported guidance: two precisions of two layouts. The one list of them.

Standard library only: the installation of the package, and make, read this before anything else is there.
So the names of files come from a table of the library, which is not imported.
``python -m c_runtime.builds`` prints it for make.
"""

import tomllib
from dataclasses import dataclass
from pathlib import Path

# The library lies beside this package in a checkout, one folder further up in an installation.
_TABLE = next(
    table
    for folder in Path(__file__).resolve().parents[1:3]
    if (table := folder / "sailnet" / "guidance" / "exported_files.toml").is_file()
)
_NAMES = tomllib.loads(_TABLE.read_text(encoding="utf-8"))

PRECISIONS: dict[str, str] = _NAMES["suffixes"]
"""What each is called in file names and at the end of every symbol."""

LAYOUTS: dict[str, str] = {layout: names["source"] for layout, names in _NAMES["layouts"].items()}
"""The file of each: what goes on board, and the same on vectors for simulation."""

HEADER: str = _NAMES["header"]
BATCH = "sailnet_batch.c"


@dataclass(frozen=True)
class Build:
    """One way to compile the guidance.

    Attributes:
        precision: ``float32`` or ``float64``.
        layout: ``flight`` or ``host``.
    """

    precision: str
    layout: str

    @property
    def suffix(self) -> str:
        """At the end of every symbol: ``f32`` or ``f64``."""
        return PRECISIONS[self.precision]

    @property
    def name(self) -> str:
        """``f32``, ``f64``, ``f32_host`` or ``f64_host``."""
        return str(_NAMES["layouts"][self.layout]["build"].format(suffix=self.suffix))

    @property
    def source(self) -> str:
        """Name of the C file."""
        return LAYOUTS[self.layout]

    @property
    def defines(self) -> tuple[str, ...]:
        """Options of the compiler that choose it; whatever includes the header needs them too."""
        return ("-DSAILNET_FLOAT64",) if self.precision == "float64" else ()

    @property
    def optimisation(self) -> tuple[str, ...]:
        """Options of the compiler for this build alone: the host's vectors are written, gcc makes no more."""
        return ("-fno-tree-vectorize",) if self.layout == "host" else ()

    @property
    def analysed(self) -> tuple[str, ...]:
        """The same for analysers, which cannot read vectors: the host's form on single numbers."""
        return (*self.tested, *(("-DSAILNET_PLAIN",) if self.layout == "host" else ()))

    @property
    def tested(self) -> tuple[str, ...]:
        """Options for what includes ``tested.h``, and with it the whole file."""
        return (*self.defines, *(("-DTESTED_HOST",) if self.layout == "host" else ()))

    @property
    def library(self) -> str:
        """Name of the shared library."""
        return str(_NAMES["library"].format(build=self.name))


def reads_beta(exported: Path) -> bool:
    """Whether the networks in a folder that was exported are in approach coordinates.

    Raises:
        ValueError: the header does not say so.
    """
    for line in _header_lines(exported):
        if line.startswith("#define SAILNET_READS_BETA "):
            return line.endswith("1")
    raise ValueError(f"{exported / HEADER} does not define SAILNET_READS_BETA: export it anew")


def in_space(exported: Path) -> bool:
    """Whether what was exported into a folder steers in three dimensions."""
    return "#define SAILNET_IN_SPACE 1" in _header_lines(exported)


def _header_lines(exported: Path) -> list[str]:
    return (exported / HEADER).read_text(encoding="utf-8").splitlines()


BUILDS = {
    build.name: build
    for build in (Build(precision, layout) for layout in LAYOUTS for precision in PRECISIONS)
}
"""By name; those that fly come first."""


def for_make() -> str:
    """Variables of make: the names of all builds, of those that fly, and of each what it is made of."""
    flying = [name for name, build in BUILDS.items() if build.layout == "flight"]
    lines = [f"BUILDS = {' '.join(BUILDS)}", f"FLYING = {' '.join(flying)}"]
    for name, build in BUILDS.items():
        lines += [
            f"SOURCE_{name} = {build.source}",
            f"DEFINES_{name} = {' '.join(build.defines)}",
            f"TESTED_{name} = {' '.join(build.tested)}",
        ]
    return "\n".join(lines)


if __name__ == "__main__":
    print(for_make())
