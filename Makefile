# `make` sets up everything and runs the whole pipeline; `make test` runs every test.
# Each step is redone only when what it depends on has changed.

# The name of a mission, or the path of one's own file; its name in folders; quick or full.
MISSION ?= earth_mars
NAME    := $(basename $(notdir $(MISSION)))
SIZE    ?= full
BUILD   ?= build/$(NAME)$(if $(filter full,$(SIZE)),,-$(SIZE))
SEED    ?= 2
FLIGHTS ?= $(if $(filter quick,$(SIZE)),1000,10000)
# Processes that `make test` spreads over.
JOBS    ?= 2
# wide: the networks that fly; box: the paper's own recipe, for missions that have one.
RECIPE  ?= wide
PYTHON3 ?= python3
VENV    ?= .venv
PYTHON  := $(VENV)/bin/python
SAILNET := $(VENV)/bin/sailnet
READY   := $(VENV)/.ready
# Markers of tests that need more than a bare machine or a few minutes; pyproject.toml says what each is.
TOOLS   := exhaustive or emulator or browser or analyser or docs or peer or install or repository or mount or cuda
# Threads of BLAS beside the processes would only wait for each other.
PYTEST  := OMP_NUM_THREADS=1 $(PYTHON) -m pytest -n $(JOBS) --dist worksteal

# What a data set depends on, and what is compiled when the package is installed.
physics  := $(wildcard sailnet/physics/*.py sailnet/expert/*.py)
plant    := $(wildcard c_runtime/simulation/plant/*.* c_runtime/simulation/plant/*/*)
tracker  := $(wildcard c_runtime/flight/tracker/*.[ch] c_runtime/simulation/tracker/*.c)
mission  := $(or $(filter %.toml,$(MISSION)),$(wildcard sailnet/mission/missions/$(MISSION).toml)) $(wildcard sailnet/mission/*.py)
run      := $(BUILD)/$(RECIPE)
networks := $(run)/networks
exported := $(run)/export
learned  := $(run).h5
exporter := $(wildcard export/*.py c_runtime/builds.py sailnet/guidance/exported_files.toml \
    $(addsuffix /*.*,c_runtime/flight c_runtime/simulation c_runtime/simulation/host))
plain    := $(BUILD)/plain-law
told     := $(BUILD)/told-ageing

# Campaigns that are flown in both precisions, and how one is flown.
IN_BOTH := law everything
fly_campaign = $(SAILNET) evaluate --overwrite --mission $(MISSION) --workers 2 \
    $(addprefix --flights ,$(CAMPAIGN_FLIGHTS)) --campaign

# Where the tables of campaigns stand: those of other missions beside their networks.
campaign_tables := $(if $(filter earth_mars,$(NAME)),sailnet/campaign,sailnet/shipped/$(NAME))/RESULTS.md

.PHONY: all paper papers setup dataset coverage train released export evaluate accept campaigns others missions bench benchmarks bad-days report ship quick test test-tools test-long tools peers docs mutation evidence checks lint clean
.DELETE_ON_ERROR:

all: accept
	@echo
	@echo "The networks: $(networks); the C that flies: $(exported)/sailnet_guidance.c"

# The paper reproduced: its data, its networks, its Section 5, as a page.
paper:
	$(MAKE) report RECIPE=box
	@echo
	@echo "The report: $(BUILD)/box/report/index.html"

setup: $(READY)

$(READY): pyproject.toml constraints.txt setup.py $(wildcard sailnet/shipped/*/sailnet_guidance*.[ch]) \
    c_runtime/builds.py c_runtime/shared_library.py sailnet/guidance/exported_files.toml $(plant) $(tracker)
	@$(PYTHON3) -c 'import sys; sys.exit(sys.version_info < (3, 11))' || \
	    { echo "sailnet needs Python 3.11 or newer; say make PYTHON3=/path/to/python3.11"; exit 1; }
	@$(PYTHON) --version >/dev/null 2>&1 || $(PYTHON3) -m venv $(VENV) || \
	    { echo "no environment could be made with $(PYTHON3): on Debian, apt install python3-venv"; exit 1; }
	$(PYTHON) -m pip install --quiet --disable-pip-version-check -c constraints.txt -e '.[train,report,cluster,dev]'
	@touch $@

# A run that was killed goes on where it was, and what the same sources made already is kept; RESTART=1 begins anew.
dataset: $(learned)
$(BUILD)/wide.h5 $(BUILD)/domain.h5 $(BUILD)/box.h5: $(BUILD)/%.h5: $(mission) $(physics) \
    sailnet/networks/approach.py $(wildcard sailnet/dataset/*.py data/*.py) | $(READY)
	$(SAILNET) data $@ --mission $(MISSION) --size $(SIZE) --recipe $* --overwrite $(if $(RESTART),--restart)
	@touch $@

# Share of optimal trajectories from fresh random starts that lie near samples.
coverage: $(BUILD)/domain.h5
	$(PYTHON) -m data.coverage $< --seed $(SEED)

# Trains until a training passes the mission's development flights (`select`); the paper's own recipe, which has none,
# is trained once. --resume: a run that was killed goes on, and networks that it finished are kept; --overwrite: no
# others are. SEED_OF_TRAINING=11: the first seed, instead of the mission's.
train: $(networks)/trained
$(networks)/trained: $(learned) $(mission) $(wildcard sailnet/networks/*.py training/*.py) $(exporter) | $(READY)
	$(SAILNET) $(if $(filter wide,$(RECIPE)),select,train) $< $(networks) --mission $(MISSION) \
	    $(if $(filter wide,$(RECIPE)),--size $(SIZE)) $(addprefix --seed ,$(SEED_OF_TRAINING)) --resume --overwrite
	@touch $@

# The released networks in place of trained ones: `make released ship` flies them again after a change of the law.
released: $(learned)
	mkdir -p $(networks) && cp sailnet/shipped/$(NAME)/*.safetensors $(networks)
	@touch $(networks)/trained

# The paper compares with guidance by two networks: it needs the one for the signed cone angle.
export: $(exported)/exported
$(exported)/exported: $(networks)/trained $(exporter) | $(READY)
	$(SAILNET) export $(networks) $(exported) --mission $(MISSION) --overwrite \
	    $(if $(filter wide,$(RECIPE)),,--baseline $(networks)/alpha.safetensors)
	@touch $@

evaluate: $(exported)/exported
	$(SAILNET) evaluate --mission $(MISSION) --networks $(exported) --flights $(FLIGHTS) --seed $(SEED) \
	    --workers 2

# Everything a set of networks has to stand, and the table of it. Flown anew only where the networks or the
# source that flights depend on have changed: the command knows.
accept: $(exported)/exported
	$(SAILNET) accept $(exported) --mission $(MISSION) \
	    --flights $(FLIGHTS) --seed $(SEED) --workers 2 --output $(run) --overwrite $(if $(RESTART),--restart)

# The same networks without plan, thrust margin, tangential force and dead reckoning, for comparison.
$(plain)/exported: $(wildcard sailnet/shipped/$(NAME)/*.safetensors) $(exporter) sailnet/guidance/rules.py | $(READY)
	$(SAILNET) export sailnet/shipped/$(NAME) $(plain) --mission $(MISSION) --plain-law --overwrite
	@touch $@

# And with the knowledge that the sail ages, for the campaign of such.
$(told)/exported: $(wildcard sailnet/shipped/$(MISSION)/*.safetensors) $(exporter) sailnet/guidance/rules.py | $(READY)
	$(PYTHON) -m export sailnet/shipped/$(MISSION) $(told) --mission $(MISSION) --degradation 0.1 --overwrite
	@touch $@

# Every other campaign with the networks that ship: results, pages, pictures; then the tables of them. One that
# was flown already with the same flight file is only reported anew. Some are flown in float32 too, which is what a
# Cortex-M4F flies (PRECISION=both: all), and `law` by the plain law. CAMPAIGN_FLIGHTS=500: small.
campaigns: $(plain)/exported $(told)/exported | $(READY)
	for name in $(filter-out acceptance,$(basename $(notdir $(wildcard sailnet/campaign/campaigns/*.toml)))); do \
	    case " $(IN_BOTH) " in *" $$name "*) precision=both;; *) precision=$(or $(PRECISION),float64);; esac; \
	    $(fly_campaign) $$name --precision $$precision --output $(BUILD)/campaigns || exit 1; \
	done
	$(fly_campaign) law --networks $(plain) --output $(BUILD)/campaigns/plain-law --optima $(BUILD)/campaigns/law.h5
	$(fly_campaign) ageing --networks $(told) --output $(BUILD)/campaigns/told-ageing \
	    --optima $(BUILD)/campaigns/ageing.h5
	$(if $(CAMPAIGN_FLIGHTS),,$(PYTHON) -m sailnet.campaign.score_tables $(BUILD)/campaigns $(campaign_tables))

# The campaign `law` by other guidances, fewer flights, and the table of them beside the networks'.
others: | $(READY)
	for way in expert:200 expert-without-reserve:200; do \
	    $(fly_campaign) law --guidance $${way%:*} --flights $${way#*:} --output $(BUILD)/campaigns || exit 1; \
	done
	$(PYTHON) -m sailnet.campaign.upper_bound $(BUILD)/campaigns sailnet/campaign/RESULTS.md

bench: $(run)/bench.json
$(run)/bench.json: $(exported)/exported $(wildcard c_runtime/verification/bench/*) | $(READY)
	$(PYTHON) -m c_runtime.verification.bench $(exported) --networks $(networks) --json > $@

$(run)/agreement.json: $(exported)/exported | $(READY)
	$(PYTHON) -m export.agreement $(networks) $(exported) --dataset $(learned) > $@

# Of the paper's form only: RECIPE=box. What is flown already is only drawn anew.
report: $(run)/bench.json $(run)/agreement.json
	$(PYTHON) -m sailnet.report --mission $(MISSION) --build $(run) --dataset $(learned) --output $(run)/report \
	    --seed $(SEED) --overwrite $(if $(RESTART),--restart)

# Make the networks of the last run the ones that come with the package; their figures go into the model
# card and, with those of the last `make paper`, into RESULTS.md; of earth_mars a few into the README.
ship: accept $(run)/bench.json $(run)/agreement.json
	$(PYTHON) -m export.ship $(run) sailnet/shipped/$(NAME) --mission $(MISSION) --results RESULTS.md \
	    $(if $(filter earth_mars,$(NAME)),--readme README.md --picture docs/flight.png) \
	    $(addprefix --paper ,$(wildcard $(BUILD)/box/report/report.json))

# The missions that ship as one table with pictures, from what was written by `make ship` and `make campaigns`.
missions: | $(READY)
	$(PYTHON) -m export.shipped_index sailnet/shipped/README.md --draw build

# The expert, generation, coverage and training beside their peers; some twenty minutes.
# torch-levenberg-marquardt takes part if it is installed: make peers.
benchmarks: | $(READY)
	$(PYTHON) -m benchmarks --seed $(SEED)

# Kills, second writers, lost clusters and full disks, every command at toy size, and hostile files for every loader:
# the tables of benchmarks/BAD_DAYS.md. KILLS=20 SIZES=20: longer; needs the right to mount.
bad-days: | $(READY)
	$(PYTHON) -m benchmarks.bad_days --kills $(or $(KILLS),5) --sizes $(or $(SIZES),5) --text benchmarks/BAD_DAYS.md
	$(PYTHON) -m benchmarks.fuzz_loaders --minutes $(or $(MINUTES),9) --text benchmarks/BAD_DAYS.md
	$(PYTHON) -m benchmarks.long_runs --text benchmarks/BAD_DAYS.md

# Faults put into the core packages one by one, and how many of them the tests notice; an hour or more. What is
# known already is not tried again. MINUTES=20: begin none after that.
mutation: | $(READY)
	$(PYTHON) -m pip install --quiet --disable-pip-version-check -c constraints.txt -e '.[mutation]'
	$(PYTHON) -m benchmarks.mutation --jobs $(JOBS) $(addprefix --minutes ,$(MINUTES))

# Every generated figure with its revision, and whether a source has changed since: needs git.
evidence: | $(READY)
	$(PYTHON) -m benchmarks.evidence

# Packages that ours are compared with.
peers: | $(READY)
	$(PYTHON) -m pip install --quiet --disable-pip-version-check -c constraints.txt -e '.[benchmarks,mutation]'

# The documentation, its cells executed where they have changed; without a network once its packages are there.
docs: $(VENV)/.docs-ready
	$(PYTHON) -m sphinx -W -n --keep-going -q -b html docs build/docs
	@echo
	@echo "The documentation: build/docs/index.html"

$(VENV)/.docs-ready: pyproject.toml constraints.txt | $(READY)
	$(PYTHON) -m pip install --quiet --disable-pip-version-check -c constraints.txt -e '.[docs,playground]'
	@touch $@

# Every figure that the four papers on optimal control print, beside ours and a second method's, and a page with
# every solution drawn; some minutes.
papers: | $(READY)
	$(SAILNET) papers --output build/papers --readme sailnet/papers/RESULTS.md
	$(PYTHON) -m sailnet.papers.logistic sailnet/papers/RESULTS.md
	@echo
	@echo "The report: build/papers/index.html"

lint: | $(READY)
	$(PYTHON) -m ruff check .
	$(PYTHON) -m ruff format --check .
	$(PYTHON) -m mypy
	$(VENV)/bin/lint-imports --no-cache --no-logo

# For someone at work: lint, and of every package the tests that take no second.
quick: lint
	$(PYTEST) -m "not (slow or long or $(TOOLS))"

# Every test that needs no more than Python, make, a C compiler and ten seconds.
test: lint
	$(PYTEST) -m "not (long or $(TOOLS))"

# The others, and the exhaustive ones. A tool that is missing is named with the line that installs it; where CI=true that fails.
test-tools: | $(READY)
	$(PYTEST) -m "($(TOOLS)) and not long"

# Minutes each, by independent methods or from whole sets of starts: after changes of the optimal solver, data, tracker or examples.
test-long: | $(READY)
	$(PYTEST) -m long

# Debian's packages that test-tools and checks call: apt-get install $(make -s tools).
tools:
	@echo clang libclang-rt-14-dev g++ libc6-dev-i386 valgrind cppcheck frama-c-base chromium \
	    gcc-arm-none-eabi qemu-system-arm gcc-sparc64-linux-gnu qemu-system-sparc gcc-riscv64-unknown-elf \
	    qemu-system-misc gcc-powerpc-linux-gnu libc6-dev-powerpc-cross qemu-user rustc octave git

# Proof, fuzzing, memcheck, MISRA, coverage and warnings of the C that ships; a tool that is missing is named.
checks: | $(READY)
	$(MAKE) -j $(JOBS) -C c_runtime check PYTHON=$(abspath $(PYTHON)) EXPORTED=$(abspath sailnet/shipped/$(NAME))

clean:
	rm -rf build
