"""What every artefact says about the software that made it."""

import hashlib
import importlib
import platform
import subprocess
from datetime import UTC, datetime
from importlib.metadata import version
from pathlib import Path
from types import ModuleType

import heyoka

import sailnet


def software() -> dict[str, str]:
    """Versions, source revision, machine and date."""
    return {
        "sailnet": sailnet.__version__,
        "revision": _revision(),
        "heyoka": version("heyoka"),
        "numpy": version("numpy"),
        "python": platform.python_version(),
        "machine": machine(),
        "date": datetime.now(UTC).strftime("%Y-%m-%d"),
    }


def environment(packages: tuple[str, ...]) -> dict[str, str]:
    """What the last bit of a computed number may depend on: equal means the numbers are equal.

    Args:
        packages: names of packages whose source counts; ``sailnet`` always does.

    Raises:
        ModuleNotFoundError: a package cannot be imported here.
    """
    sources = {
        f"source of {name}": _source_digest(importlib.import_module(name)) for name in ("sailnet", *packages)
    }
    versions = {name: version(name) for name in ("heyoka", "numpy", "scipy")}
    return {**versions, "SIMD width": str(heyoka.recommended_simd_size()), **sources}


def _source_digest(package: ModuleType) -> str:
    digest = hashlib.sha256()
    (folder,) = (Path(place) for place in package.__path__)
    for path in sorted(folder.rglob("*.py")):
        digest.update(path.relative_to(folder).as_posix().encode() + b"\0" + path.read_bytes())
    return digest.hexdigest()[:16]


def machine() -> str:
    """Processor and operating system, in words."""
    name = platform.processor() or platform.machine()
    cpuinfo = Path("/proc/cpuinfo")
    if cpuinfo.exists():
        for line in cpuinfo.read_text().splitlines():
            if line.startswith("model name"):
                name = line.split(":", 1)[1].strip()
                break
    return f"{name}, {platform.system()}"


def _revision() -> str:
    folder = Path(__file__).parent
    try:
        described = subprocess.run(
            ["git", "describe", "--always", "--dirty"], cwd=folder, capture_output=True, text=True, check=True
        )
    except (OSError, subprocess.CalledProcessError):
        return "unknown"
    return described.stdout.strip()
