"""Solvers of optimal-control problems, a module each: ``SOLVER.solve(problem, guess, options=options)``.

All have that one form, so that a solver is exchanged by its name, and a table of solvers needs no
functions in between: *what* is solved comes first, *where* to begin second, *how* last and by name.

- ``problem`` is a :class:`~sailnet.ocp.definition.problem.Problem`.
- ``guess`` is a :class:`~sailnet.ocp.definition.solution.Solution` of it or of a near problem, or what the
  solver can begin at without one: costates, straight lines, random draws, whose seed and number are a
  guess's and no option's. Where it has a default, None stands for that.
- ``options`` are the solver's own frozen ``Options``, checked when they are built. The smoothing and its
  schedule are among them: of one and the same problem they say how it is approached.

Each returns a :class:`~sailnet.ocp.definition.solution.Solution` or raises a
:class:`~sailnet.ocp.definition.solution.ConvergenceError`.
"""
