# The flight file on the processors it is for, in emulation. NETWORKS: folder of the weights, if it is another.
TARGETS_BUILD = $(BUILD)/targets
TARGETS = cd .. && $(PYTHON) -m c_runtime.verification.targets $(abspath $(EXPORTED)) --build $(abspath $(TARGETS_BUILD)) \
    $(if $(NETWORKS),--networks $(abspath $(NETWORKS))) $(TARGETS_OPTIONS)

.PHONY: targets targets-table targets-flights
targets:
	$(TARGETS)

targets-table:
	$(TARGETS) --table c_runtime/RESULTS.md

# One flight of each mission that ships by each processor, over the console of its emulator.
targets-flights:
	cd .. && $(PYTHON) -m c_runtime.verification.targets fly --build $(abspath $(BUILD)/flights) \
	    --table c_runtime/RESULTS.md $(TARGETS_OPTIONS)
