"""From a state to a command: one interface; the exported C, its ONNX graphs and a reference behind it."""
