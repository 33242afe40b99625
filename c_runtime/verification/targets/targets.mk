# The flight file on the processors it is for, in emulation. NETWORKS: folder of the weights, if it is another.
TARGETS_BUILD = $(BUILD)/targets
TARGETS = cd .. && $(PYTHON) -m c_runtime.verification.targets $(abspath $(EXPORTED)) --build $(abspath $(TARGETS_BUILD)) \
    $(if $(NETWORKS),--networks $(abspath $(NETWORKS))) $(TARGETS_OPTIONS)

.PHONY: targets targets-table
targets:
	$(TARGETS)

targets-table:
	$(TARGETS) --table c_runtime/RESULTS.md
