"""What commands print: one JSON object for machines, aligned lines for people."""

Result = dict[str, object]
"""What a command found, by name."""


def readable(value: object) -> str:
    """A value as people read it: eight digits, lists in a row, tables indented."""
    if isinstance(value, float):
        return f"{value:.8g}"
    if isinstance(value, (list, tuple)):
        return "  ".join(readable(item) for item in value)
    if isinstance(value, dict):
        return "\n".join([""] + [f"    {key:20s} {readable(item)}" for key, item in value.items()])
    return str(value)
