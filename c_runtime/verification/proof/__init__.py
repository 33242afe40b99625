"""The proof that commands are bounded and finite for any input bits, and the mutants that break it."""
