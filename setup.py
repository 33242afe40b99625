"""Compiles the released guidance, the tracker and the plant, and packs the pipeline's stages."""

import shutil
import sys
from pathlib import Path

from setuptools import Extension, setup
from setuptools.command.build_ext import build_ext
from setuptools.command.build_py import build_py

ROOT = Path(__file__).parent.resolve()
sys.path.insert(0, str(ROOT))

from c_runtime.builds import BUILDS  # noqa: E402
from c_runtime.shared_library import (  # noqa: E402
    CHECKSUMS,
    PLANT_LIBRARY,
    TRACKER_LIBRARIES,
    compile_libraries,
    compile_plant,
    compile_tracker,
)

SHIPPED = sorted(path.parent.relative_to(ROOT) for path in ROOT.glob("sailnet/shipped/*/sailnet_guidance.c"))
PLANT = Path("sailnet/flight/native")
TRACKER = Path("sailnet/guidance/tracker/native")
STAGES = "sailnet_stages"
"""Folder of an installation for packages whose names are too general to stand beside others; it is put on the
path when one of them is to run, see sailnet/workers/stages.py."""
PACKED = (
    *("data", "training", "export"),
    *("c_runtime/*.py", "c_runtime/flight", "c_runtime/simulation", "c_runtime/fmi"),
)
"""What lies there: what the pipeline runs, the C that it exports, and what makes an FMU of it."""


class BuildGuidance(build_ext):
    """Plain shared libraries (they are loaded by ctypes) beside the C they are made of."""

    def run(self) -> None:
        """Compile into the build folder, or in place for an editable installation."""
        for folder in SHIPPED:
            compile_libraries(ROOT / folder, self._base() / folder)
        compile_plant(self._base() / PLANT)
        compile_tracker(self._base() / TRACKER)

    def get_outputs(self) -> list[str]:
        """The files that ``run`` writes."""
        names = [*(build.library for build in BUILDS.values()), CHECKSUMS]
        written = [folder / name for folder in SHIPPED for name in names]
        written += [PLANT / name for name in (PLANT_LIBRARY, CHECKSUMS)]
        written += [TRACKER / name for name in (*TRACKER_LIBRARIES.values(), CHECKSUMS)]
        return [str(self._base() / file) for file in written]

    def get_output_mapping(self) -> dict[str, str]:
        """Nothing is built elsewhere and copied."""
        return {}

    def _base(self) -> Path:
        in_place = self.inplace or getattr(self, "editable_mode", False)
        return ROOT if in_place else Path(self.build_lib)


class BuildStages(build_py):
    """Packs the stages beside the package; an editable installation finds them in the checkout."""

    def run(self) -> None:
        """Copy them, without what other builds left among them."""
        super().run()
        for source, target in self._stages().items():
            target.parent.mkdir(parents=True, exist_ok=True)
            shutil.copyfile(source, target)

    def get_outputs(self, include_bytecode: bool = True) -> list[str]:
        """What the package consists of, and the files that ``run`` writes."""
        return [*super().get_outputs(include_bytecode), *map(str, self._stages().values())]

    def _stages(self) -> dict[Path, Path]:
        if getattr(self, "editable_mode", False):
            return {}
        named = [path for pattern in PACKED for path in ROOT.glob(pattern)]
        files = [file for path in named for file in ([path] if path.is_file() else sorted(path.rglob("*.*")))]
        kept = {".py", ".c", ".h", ".inc", ".in"}
        return {
            file: Path(self.build_lib) / STAGES / file.relative_to(ROOT)
            for file in files
            if file.suffix in kept
        }


setup(
    ext_modules=[Extension(".".join(folder.parts), sources=[]) for folder in [*SHIPPED, PLANT, TRACKER]],
    cmdclass={"build_ext": BuildGuidance, "build_py": BuildStages},
)
