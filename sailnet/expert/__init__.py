"""The fastest extremal from any state, by backward shooting."""
