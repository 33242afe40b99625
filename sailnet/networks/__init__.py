"""The networks: weights, what they read, where they may be trusted."""
