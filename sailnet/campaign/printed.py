"""Figures printed in the paper, and the starts and settings of its Section 5.

Wang, Lu, Chen, Li: "Real-time optimal control for attitude-constrained solar sailcrafts via
neural networks". Section, table and equation numbers are the paper's.
"""

CASES = {"Case 1": (1.0, 0.0, 1.0), "Case 2": (1.05, 0.15, 1.03)}
"""Table 2: (r, u, v)."""

CASE_OPTIMUM = {"Case 1": 7.0184, "Case 2": 6.1552}
CASE_PREDICTED = {"Case 1": 7.0192, "Case 2": 6.1643}
CASE_ERROR = {"Case 1": (5.3703e-7, 3.0121e-5, 3.6943e-5), "Case 2": (5.2011e-6, 3.3526e-4, 1.5393e-4)}
CASE_1_ERROR_TWO_NETWORKS = (2.2220e-5, 4.1852e-4, 2.5968e-4)

NOISE_START = (1.1, 0.18, 0.93)
NOISE = 0.15
NOISE_TIME = 5.9152
NOISE_ERROR = (2.0160e-5, 9.8708e-5, 8.4738e-5)

GENERALISATION_FLIGHTS, GENERALISATION_SUCCESSES = 30, 20
GENERALISATION_ERROR = (4.5091e-5, 1.4726e-4, 1.0147e-4)

TIMES = {"unconstrained": 7.01204, "constrained": 7.01818, "smoothed": 7.01838}
"""Section 4.1.1: phi_max = 90 deg; 60 deg with delta = 0; 60 deg with delta = 1e-3 [TU]."""

TRAJECTORIES, SAMPLES = 18_324, 6_416_613

ERRORS = {
    "tau": (1e-8, 1e-8, 1e-8),
    "lambda_v": (4.94e-6, 5.02e-6, 5.07e-6),
    "alpha_pre": (7.53e-7, 6.82e-7, 7.70e-7),
    "alpha": (1.72e-6, 3.53e-6, 2.55e-6),
}
"""Table 1: training, validation and test MSE, outputs scaled to [0, 1]."""

COMMAND_SECONDS = 0.0177e-3
"""Section 5.4: mean time of a command, in C on a desktop."""
