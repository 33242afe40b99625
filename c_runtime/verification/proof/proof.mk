# The proof, in every build: make proof EXPORTED=<folder>; PROOF_OPTIONS=--mutants also breaks the file.
PROOF_OPTIONS ?=

.PHONY: proof
check: proof
proof:
	cd .. && $(PYTHON) -m c_runtime.verification.proof $(abspath $(EXPORTED)) $(if $(REQUIRE),--require) $(PROOF_OPTIONS)
