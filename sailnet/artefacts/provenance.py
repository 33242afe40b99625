"""What every artefact says about the software that made it."""

import ast
import hashlib
import importlib.util
import platform
import subprocess
from collections.abc import Iterator, Mapping
from datetime import UTC, datetime
from importlib.metadata import version
from pathlib import Path
from types import ModuleType

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
    """What the last bit of any number of ours may depend on: equal means the numbers are equal.

    Args:
        packages: names of packages whose source counts; ``sailnet`` always does.

    Raises:
        ModuleNotFoundError: a package cannot be imported here.
    """
    sources = {
        f"source of {name}": _digest(_files(importlib.import_module(name))) for name in ("sailnet", *packages)
    }
    return {**_versions(), **sources}


def environment_of(*modules: str) -> dict[str, str]:
    """What the last bit of the numbers that some modules compute may depend on: no other source of ours.

    Args:
        modules: by name; whatever they import of their own top-level packages counts too.
    """
    return {**_versions(), f"source of {', '.join(modules)}": _digest(_imported(modules))}


def _versions() -> dict[str, str]:
    import heyoka  # half a second: whoever comes second into a place has been sent away by now

    versions = {name: version(name) for name in ("heyoka", "numpy", "scipy")}
    return {**versions, "SIMD width": str(heyoka.recommended_simd_size())}


def _files(package: ModuleType) -> dict[str, Path]:
    (folder,) = (Path(place) for place in package.__path__)
    return {path.relative_to(folder).as_posix(): path for path in folder.rglob("*.py")}


def _imported(modules: tuple[str, ...]) -> dict[str, Path]:
    """The files of modules and of all that they import, directly or not, of the same top-level packages."""
    packages = {name.partition(".")[0] for name in (*modules, "sailnet")}
    found: dict[str, Path] = {}
    waiting = list(modules)
    while waiting:
        name = waiting.pop()
        if name in found or name.partition(".")[0] not in packages:
            continue
        try:
            spec = importlib.util.find_spec(name)
        except ModuleNotFoundError:  # of ``from module import name``, the name
            continue
        if spec is None or spec.origin is None:
            continue
        found[name] = Path(spec.origin)
        waiting.append(name.rpartition(".")[0])  # a package is imported with its modules
        for node in _run(ast.parse(found[name].read_bytes())):
            if isinstance(node, ast.Import):
                waiting += [alias.name for alias in node.names]
            elif isinstance(node, ast.ImportFrom) and node.module:
                waiting += [node.module, *(f"{node.module}.{alias.name}" for alias in node.names)]
    return found


def _run(tree: ast.AST) -> Iterator[ast.AST]:
    """What of a source is run: all but what only type checkers read."""
    if isinstance(tree, ast.If) and isinstance(tree.test, ast.Name) and tree.test.id == "TYPE_CHECKING":
        return
    yield tree
    for node in ast.iter_child_nodes(tree):
        yield from _run(node)


def _digest(files: Mapping[str, Path]) -> str:
    digest = hashlib.sha256()
    for name in sorted(files):
        digest.update(name.encode() + b"\0" + files[name].read_bytes())
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
    """Of the sources: texts and pictures, which commands write into, make it no other one."""
    sources = (":(top)", ":(top,exclude)*.md", ":(top,exclude)*.png")
    try:
        described = _git("describe", "--always").stdout.strip()
        changed = _git("diff-index", "--name-only", "HEAD", "--", *sources).stdout.strip()
    except (OSError, subprocess.CalledProcessError):
        return "unknown"
    return f"{described}-dirty" if changed else described


def _git(*arguments: str) -> subprocess.CompletedProcess[str]:
    folder = Path(__file__).parent
    return subprocess.run(["git", *arguments], cwd=folder, capture_output=True, text=True, check=True)
