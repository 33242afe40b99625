"""What holds the flight file to its claims: tests, checks, proof, accuracy, processors and times."""
