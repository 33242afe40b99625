"""An exported guidance as a Functional Mock-up Unit, for simulators that take FMI 3.0."""
