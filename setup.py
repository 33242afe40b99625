"""Compiles the shipped guidance and the plant when the package is built: no compiler at run time."""

import sys
from pathlib import Path

from setuptools import Extension, setup
from setuptools.command.build_ext import build_ext

ROOT = Path(__file__).parent.resolve()
sys.path.insert(0, str(ROOT))

from c_runtime.builds import BUILDS  # noqa: E402
from c_runtime.shared_library import (  # noqa: E402
    CHECKSUMS,
    PLANT_LIBRARY,
    compile_libraries,
    compile_plant,
)

SHIPPED = sorted(path.parent.relative_to(ROOT) for path in ROOT.glob("sailnet/shipped/*/sailnet_guidance.c"))
PLANT = Path("sailnet/flight/native")


class BuildGuidance(build_ext):
    """Plain shared libraries (they are loaded by ctypes) beside the C they are made of."""

    def run(self) -> None:
        """Compile into the build folder, or in place for an editable installation."""
        for folder in SHIPPED:
            compile_libraries(ROOT / folder, self._base() / folder)
        compile_plant(self._base() / PLANT)

    def get_outputs(self) -> list[str]:
        """The files that ``run`` writes."""
        names = [*(build.library for build in BUILDS.values()), CHECKSUMS]
        written = [folder / name for folder in SHIPPED for name in names]
        written += [PLANT / name for name in (PLANT_LIBRARY, CHECKSUMS)]
        return [str(self._base() / file) for file in written]

    def get_output_mapping(self) -> dict[str, str]:
        """Nothing is built elsewhere and copied."""
        return {}

    def _base(self) -> Path:
        in_place = self.inplace or getattr(self, "editable_mode", False)
        return ROOT if in_place else Path(self.build_lib)


setup(
    ext_modules=[Extension(".".join(folder.parts), sources=[]) for folder in [*SHIPPED, PLANT]],
    cmdclass={"build_ext": BuildGuidance},
)
