"""The extremals' equations as JavaScript, from the expressions that everything else is derived from."""

import ast
from typing import Any

import heyoka as hy

from sailnet.physics.dynamics import alpha, motion
from sailnet.physics.pontryagin import BETA, extremal_motion, saturated_angle, unconstrained_angle
from sailnet.physics.transfer import Transfer

_OPERATORS = {ast.Add: "+", ast.Sub: "-", ast.Mult: "*", ast.Div: "/", ast.Gt: ">"}
_FUNCTIONS = ("cos", "sin", "atan2")

UNKNOWNS = ("r", "u", "v", "lambda_r", "lambda_u", "lambda_v", "theta")


def javascript(expression: Any) -> str:
    """An expression of heyoka, which writes it as Python would, but for ``select``.

    Raises:
        ValueError: it is too long for heyoka to write, or has a part that is not known here.
    """
    text = str(expression)
    if text.endswith("..."):
        raise ValueError("heyoka does not write an expression as long as this")
    return _written(ast.parse(text, mode="eval").body)


def _written(node: ast.expr) -> str:
    match node:
        case ast.Name(id=name):
            return name
        case ast.Constant(value=value):
            return repr(value)
        case ast.UnaryOp(op=ast.USub(), operand=operand):
            return f"(-{_written(operand)})"
        case ast.BinOp(op=ast.Pow(), left=left, right=right):
            return f"Math.pow({_written(left)}, {_written(right)})"
        case ast.BinOp(op=op, left=left, right=right) if type(op) in _OPERATORS:
            return f"({_written(left)} {_OPERATORS[type(op)]} {_written(right)})"
        case ast.Compare(left=left, ops=[op], comparators=[right]) if type(op) in _OPERATORS:
            return f"({_written(left)} {_OPERATORS[type(op)]} {_written(right)})"
        case ast.Call(func=ast.Name(id="select"), args=[condition, either, other]):
            return f"({_written(condition)} ? {_written(either)} : {_written(other)})"
        case ast.Call(func=ast.Name(id=name), args=arguments) if name in _FUNCTIONS:
            return f"Math.{name}({', '.join(map(_written, arguments))})"
    raise ValueError(f"no JavaScript is known here for {ast.dump(node)}")


def extremal_script(transfer: Transfer) -> str:
    """A script with ``extremal``: ``slopes`` of the unknowns, Eqs. (1) and (8), and ``angle``, Eq. (12).

    Args:
        transfer: the problem; its sail must be ideal.
    """
    bar = hy.make_vars("bar")
    slopes = {str(name): slope for name, slope in extremal_motion(alpha)}
    slopes["theta"] = motion(BETA, alpha)["theta"]
    unknowns = ", ".join(UNKNOWNS)
    written = ",\n    ".join(javascript(slopes[name]) for name in UNKNOWNS)
    return f"""// Written from the expressions of sailnet/physics.
const extremal = (() => {{
  const p0 = {transfer.beta!r}, p1 = {transfer.phi_max!r}, p2 = {transfer.delta!r};
  function angle([{unknowns}]) {{
    const p3 = lambda_v > 0 ? -1 : 1, bar = {javascript(unconstrained_angle())};
    return {javascript(saturated_angle(bar))};
  }}
  function slopes(y) {{
    const [{unknowns}] = y, alpha = angle(y);
    return [{written}];
  }}
  return {{ angle, slopes }};
}})();"""
