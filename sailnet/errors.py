"""The one exception family a caller of sailnet needs to catch, and what its messages have in common."""

import os
from collections.abc import Iterable
from difflib import get_close_matches


def reason(error: Exception) -> str:
    """Why a file could not be used, in words alone: what libraries add to them are numbers of their own."""
    number = error.errno if isinstance(error, OSError) else None
    return str(error) if number is None else os.strerror(number).lower()


def did_you_mean(word: str, known: Iterable[str]) -> str:
    """What a refusal of a name adds to it: the known name that is most like it, or nothing."""
    nearest = get_close_matches(word, list(known), n=1)
    return f"; did you mean {nearest[0]}?" if nearest else ""


class SailnetError(Exception):
    """Something is wrong with what sailnet was given; the message says what to do about it."""


class MissionError(SailnetError):
    """A mission file that cannot be used."""


class DatasetError(SailnetError):
    """A data set that is damaged, incomplete or not the one asked for."""


class NetworkError(SailnetError):
    """Network weights that are damaged or do not belong together."""


class SolveError(SailnetError):
    """No extremal was found that meets the boundary conditions."""


class GuidanceError(SailnetError):
    """A guidance back end that cannot be loaded or run."""


class CampaignError(SailnetError):
    """A campaign that cannot be flown, or results of one that are damaged."""
