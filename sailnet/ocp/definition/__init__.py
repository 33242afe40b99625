"""What an optimal-control problem is, and what Pontryagin's principle makes of it.

A :mod:`~sailnet.ocp.definition.problem` states dynamics, cost, bounds and ends;
:mod:`~sailnet.ocp.definition.canonical` and :mod:`~sailnet.ocp.definition.ends` derive its necessary
conditions under a form of the control law (:mod:`~sailnet.ocp.definition.smoothing`);
:mod:`~sailnet.ocp.definition.functions` compiles them, :mod:`~sailnet.ocp.definition.solution` is what
a solver returns.
"""
