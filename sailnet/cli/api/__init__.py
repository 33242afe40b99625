"""What ``import sailnet`` offers: a dozen names over the rooms below, for scripts and notebooks."""
