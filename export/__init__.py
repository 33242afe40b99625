"""From trained weights to what flies: ONNX graphs, one C99 file and the libraries compiled from it."""
