"""Compiles the shipped guidance when the package is built, so that none is needed at run time."""

import sys
from pathlib import Path

from setuptools import Extension, setup
from setuptools.command.build_ext import build_ext

ROOT = Path(__file__).parent.resolve()
sys.path.insert(0, str(ROOT))

from c_runtime.shared_library import CHECKSUMS, PRECISIONS, compile_libraries, library_name  # noqa: E402

SHIPPED = sorted(path.parent.relative_to(ROOT) for path in ROOT.glob("sailnet/shipped/*/sailnet_guidance.c"))


class BuildGuidance(build_ext):
    """Plain shared libraries (they are loaded by ctypes) beside the C they are made of."""

    def run(self) -> None:
        """Compile into the build folder, or in place for an editable installation."""
        for folder in SHIPPED:
            compile_libraries(ROOT / folder, self._base() / folder)

    def get_outputs(self) -> list[str]:
        """The files that ``run`` writes."""
        names = [*(library_name(precision) for precision in PRECISIONS), CHECKSUMS]
        return [str(self._base() / folder / name) for folder in SHIPPED for name in names]

    def get_output_mapping(self) -> dict[str, str]:
        """Nothing is built elsewhere and copied."""
        return {}

    def _base(self) -> Path:
        in_place = self.inplace or getattr(self, "editable_mode", False)
        return ROOT if in_place else Path(self.build_lib)


setup(
    ext_modules=[Extension(".".join(folder.parts), sources=[]) for folder in SHIPPED],
    cmdclass={"build_ext": BuildGuidance},
)
