"""One command by the exported graph: onnxruntime and numpy, and nothing of sailnet.

    python guide.py GRAPH R U V

The graph is the law alone: R in AU, U and V in AU/TU, and beta, the sail's characteristic acceleration.
It has no memory, plan, thrust margin or dead reckoning; the C's ``sailnet_steer`` has. A NaN must not
enter it.
"""

import json
import math
import sys

import numpy as np
import onnxruntime


def main(graph: str, *numbers: str) -> int:
    """Print the command for a state; returns the exit status."""
    session = onnxruntime.InferenceSession(graph, providers=["CPUExecutionProvider"])
    facts = json.loads(session.get_modelmeta().custom_metadata_map["sailnet_guidance"])
    kind = np.float64 if session.get_inputs()[0].type == "tensor(double)" else np.float32
    state = np.array([[float(number) for number in numbers]], kind)
    if state.shape != (1, 3) or not np.isfinite(state).all():
        print("a state is three finite numbers: R U V", file=sys.stderr)
        return 1
    given = {"state": state, "beta": np.array([facts["beta"]], kind)}
    cone_angle, time_of_flight = session.run(["cone_angle", "time_of_flight"], given)
    bound = facts["phi_max"]
    held = max(-bound, min(bound, float(cone_angle[0])))
    print(f"mission {facts['mission']}: hold {math.degrees(held):+.4f} deg, {time_of_flight[0]:.6f} TU to go")
    return 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
