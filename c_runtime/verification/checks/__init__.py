"""Checks of the exported flight file that take more than a line of make; see `checks.mk`.

Standard library only: they run wherever the C is compiled.
"""
