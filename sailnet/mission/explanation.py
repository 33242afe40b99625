"""What is wrong with a TOML table, in the words of someone who wrote it."""

from types import NoneType
from typing import get_args

from pydantic import BaseModel, ValidationError


def explain(error: ValidationError, model: type[BaseModel]) -> str:
    """What is wrong with a table, a line each: key, value, what is allowed."""
    return "\n  ".join(_explain(dict(item), model) for item in error.errors())


def _explain(problem: dict[str, object], model: type[BaseModel]) -> str:
    location = problem["loc"]
    assert isinstance(location, tuple)
    key = ".".join(str(part) for part in location)
    if problem["type"] == "extra_forbidden":
        for part in location[:-1]:
            if isinstance(part, int):  # a row of an array of tables
                continue
            annotation = model.model_fields[str(part)].annotation
            options = [option for option in get_args(annotation) or (annotation,) if option is not NoneType]
            model = options[0]
        known = sorted(field.alias or name for name, field in model.model_fields.items())
        return f"{key}: unknown key; allowed here are {', '.join(known)}"
    if problem["type"] == "missing":
        return f"{key}: this key is missing"
    return f"{key} = {problem['input']!r}: {problem['msg']}"
