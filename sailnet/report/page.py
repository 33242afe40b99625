"""Templates of this package, filled."""

from jinja2 import Environment, PackageLoader, StrictUndefined, select_autoescape


def render(template: str, **content: object) -> str:
    """Fill one of the templates of this package."""
    environment = Environment(
        loader=PackageLoader("sailnet", "report"),
        autoescape=select_autoescape(["jinja"], default=True),
        undefined=StrictUndefined,
        trim_blocks=False,
    )
    return environment.get_template(template).render(**content)
