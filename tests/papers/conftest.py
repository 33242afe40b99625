"""Papers' problems are compiled as those of the solvers' tests are."""

from tests.ocp.compiled import compiled_code_is_dropped

__all__ = ["compiled_code_is_dropped"]
