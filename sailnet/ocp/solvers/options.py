"""What the options of a solver are checked for when they are built."""

from sailnet.errors import SailnetError
from sailnet.ocp.definition.smoothing import Exact


def check_positive(options: object, *names: str) -> None:
    """Refuse numbers that are not greater than zero; None is no number.

    Args:
        options: of a solver, or a guess.
        names: of its fields.

    Raises:
        SailnetError: one of them is zero, negative or not a number.
    """
    for name in names:
        value = getattr(options, name)
        if value is not None and not value > 0.0:
            raise SailnetError(f"{_name(options)}: {name} must be greater than zero, not {value}")


def check_at_least(options: object, least: int, *names: str) -> None:
    """Refuse counts that are smaller than ``least``.

    Raises:
        SailnetError: one of them is.
    """
    for name in names:
        value = getattr(options, name)
        if not value >= least:
            raise SailnetError(f"{_name(options)}: {name} is {value}; give at least {least}")


def check_smoothed(options: object) -> None:
    """Refuse the exact law, where a solver follows a smoothing parameter.

    Raises:
        SailnetError: the options' ``smoothing`` is :class:`~sailnet.ocp.definition.smoothing.Exact`.
    """
    if isinstance(getattr(options, "smoothing", None), Exact):
        raise SailnetError(
            f"{_name(options)}: this solver cannot locate switches; take another smoothing than Exact,"
            " or shooting or arcs"
        )


def _name(options: object) -> str:
    kind = type(options)
    # A solver that is a folder has its options in a module within.
    module = kind.__module__.removesuffix(".solver").removesuffix(".options")
    return f"{module.rpartition('.')[2]}.{kind.__qualname__}"
