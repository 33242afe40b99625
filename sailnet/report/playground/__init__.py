"""A page that flies: the flight file and the plant as WebAssembly, a start to drag, a sail to disturb."""
