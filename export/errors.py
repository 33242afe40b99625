"""Errors of the export."""

from sailnet.errors import SailnetError


class ExportError(SailnetError):
    """Networks that cannot be exported, or a folder that cannot be written."""
