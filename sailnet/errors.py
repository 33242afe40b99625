"""The one exception family a caller of sailnet needs to catch."""


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
