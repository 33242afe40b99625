"""The flight runtime in C, and the one place that knows how to compile it into shared libraries."""
