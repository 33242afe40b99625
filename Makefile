# `make` sets up everything and runs the whole pipeline; `make test` runs every test.
# Each step is redone only when what it depends on has changed.

MISSION ?= earth_mars
BUILD   ?= build/$(MISSION)
SEED    ?= 2
FLIGHTS ?= 1000
# What the networks learn from: the paper's box where a mission has one, until the wide networks come.
RECIPE  ?= $(if $(filter earth_mars,$(MISSION)),box,domain)
PYTHON3 ?= python3
VENV    ?= .venv
PYTHON  := $(VENV)/bin/python
READY   := $(VENV)/.ready

physics  := $(addprefix sailnet/,dynamics.py pontryagin.py propagation.py extremals.py shooting.py \
    directions.py prisms.py index.py expert.py nominal.py)
mission  := $(wildcard sailnet/missions/$(MISSION).toml) sailnet/mission.py
networks := $(BUILD)/networks
exported := $(BUILD)/export
learned  := $(BUILD)/$(RECIPE).h5

.PHONY: all setup dataset coverage train export evaluate bench benchmarks report ship test lint clean
.DELETE_ON_ERROR:

all: report
	@echo
	@echo "The report: $(BUILD)/report/index.html"

setup: $(READY)

$(READY): pyproject.toml constraints.txt setup.py $(wildcard sailnet/shipped/*/sailnet_guidance.c)
	@$(PYTHON3) -c 'import sys; sys.exit(sys.version_info < (3, 11))' || \
	    { echo "sailnet needs Python 3.11 or newer; say make PYTHON3=/path/to/python3.11"; exit 1; }
	$(PYTHON3) -m venv $(VENV)
	$(PYTHON) -m pip install --quiet --disable-pip-version-check -c constraints.txt -e '.[train,report,cluster,dev]'
	@touch $@

# A run that was killed goes on where it was; RESTART=1 throws away what it left.
dataset: $(sort $(BUILD)/domain.h5 $(learned))
$(BUILD)/domain.h5 $(BUILD)/box.h5: $(BUILD)/%.h5: $(mission) $(physics) sailnet/jumps.py \
    $(wildcard sailnet/dataset/*.py data/*.py) | $(READY)
	$(PYTHON) -m data $@ --mission $(MISSION) --recipe $* $(if $(RESTART),--restart)

# Share of optimal trajectories from fresh random starts that lie near samples.
coverage: $(BUILD)/domain.h5
	$(PYTHON) -m data.coverage $< --seed $(SEED)

# --resume: a run that was killed goes on, and networks that are finished are kept.
train: $(networks)/trained
$(networks)/trained: $(learned) sailnet/networks.py $(wildcard training/*.py) | $(READY)
	$(PYTHON) -m training $< $(networks) --resume
	@touch $@

export: $(exported)/exported
$(exported)/exported: $(networks)/trained $(wildcard export/*.py c_runtime/include/* c_runtime/source/*) | $(READY)
	$(PYTHON) -m export $(networks) $(exported) --mission $(MISSION) --baseline $(networks)/alpha.safetensors
	@touch $@

evaluate: $(exported)/exported
	$(VENV)/bin/sailnet evaluate --mission $(MISSION) --networks $(exported) --flights $(FLIGHTS) --seed $(SEED)

bench: $(BUILD)/bench.json
$(BUILD)/bench.json: $(exported)/exported $(wildcard c_runtime/bench/*) | $(READY)
	$(PYTHON) -m c_runtime.bench $(exported) --networks $(networks) --json > $@

$(BUILD)/agreement.json: $(exported)/exported | $(READY)
	$(PYTHON) -m export.agreement $(networks) $(exported) --dataset $(learned) > $@

report: $(BUILD)/report/index.html
$(BUILD)/report/index.html: $(BUILD)/bench.json $(BUILD)/agreement.json $(wildcard sailnet/*.py sailnet/report/*) | $(READY)
	$(PYTHON) -m sailnet.report --mission $(MISSION) --build $(BUILD) --dataset $(learned) --output $(BUILD)/report \
	    --seed $(SEED) --flights $(FLIGHTS)

# Make the networks of the last run the ones that come with the package, and their figures the README's.
ship: $(BUILD)/report/index.html
	$(PYTHON) -m export.ship $(BUILD) sailnet/shipped/$(MISSION) --mission $(MISSION) --readme README.md

# The expert, generation, coverage and training beside their peers; some twenty minutes.
# torch-levenberg-marquardt takes part if it is installed: pip install -c constraints.txt -e '.[benchmarks]'.
benchmarks: | $(READY)
	$(PYTHON) -m benchmarks --seed $(SEED)

lint: | $(READY)
	$(PYTHON) -m ruff check .
	$(PYTHON) -m ruff format --check .
	$(PYTHON) -m mypy

test: lint
	$(PYTHON) -m pytest

clean:
	rm -rf build
