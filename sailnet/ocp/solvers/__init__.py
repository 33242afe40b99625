"""A module a solver, each with a ``solve`` of its own."""
