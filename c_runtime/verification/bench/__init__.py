"""Benchmarks of the flight runtime beside other ways to evaluate the same networks."""
