# The checks of the flight file, each in every build of it: make check EXPORTED=<folder>. A check whose tool
# is missing is left out with a line that says so; with REQUIRE=1, or CI set, it fails instead.

REQUIRE ?= $(CI)
FUZZ_RUNS ?= 10000
# Pseudo-random inputs of the fuzz harness under memcheck and for coverage, and cases of the unit tests there.
MEMCHECK_RUNS ?= 200
MEMCHECK_CASES ?= 100
COVERAGE_RUNS ?= 4000
COVERAGE_CASES ?= 2000
CLANG ?= clang
GCC ?= gcc

CHECKS := $(BUILD)/checks
HARNESS = verification/checks/fuzz_guidance.c
DRIVER = verification/checks/drive.c $(HARNESS)
# $(call source,build): its C file. What flies is checked in every way; the form for hosts is no flight software: it
# is not held to MISRA.
source = $(EXPORTED)/$(SOURCE_$(1))

.PHONY: check fuzz valgrind misra coverage-c warnings record-fuzz clean-checks
check: warnings misra fuzz valgrind coverage-c

# $(call present,program), $(call compiles,compiler): not empty if there is one that works.
present = $(shell command -v $(1) 2>/dev/null)
compiles = $(shell $(1) -fsyntax-only -include string.h -x c /dev/null 2>/dev/null && echo yes)
left-out/%:
	@echo "left out: $* (to have it: apt-get install $(PACKAGES_$*))"
	@test -z "$(REQUIRE)"

$(CHECKS):
	mkdir -p $@

clean: clean-checks
clean-checks:
	rm -rf $(CHECKS)

# --- fuzz: libFuzzer, address and undefined-behaviour sanitizers; any finding ends it. ---
PACKAGES_fuzz = clang libclang-rt-14-dev
FUZZER = $(wildcard $(shell $(CLANG) -print-file-name=libclang_rt.fuzzer-$(shell uname -m).a 2>/dev/null))
SANITIZE = -g -O2 -fno-omit-frame-pointer -fsanitize=fuzzer,address,undefined,float-cast-overflow \
    -fno-sanitize-recover=all
FUZZ_OPTIONS = -seed=1 -max_len=96 -detect_leaks=0 -timeout=10

fuzz: $(if $(FUZZER),$(BUILDS:%=fuzz/%),left-out/fuzz)
fuzz/%: $(CHECKS)/fuzz-%
	@$< -runs=$(FUZZ_RUNS) $(FUZZ_OPTIONS) -artifact_prefix=$(CHECKS)/$*- >$<.txt 2>&1 || { cat $<.txt; false; }
	@echo "fuzz $*: $(FUZZ_RUNS) executions, no finding"
$(CHECKS)/fuzz-%: $(HARNESS) $(SOURCES) verification/checks/checks.mk | $(CHECKS)
	@$(CLANG) -std=c99 $(WARNINGS) $(SANITIZE) $(DEFINES_$*) -I$(EXPORTED) -o $@ $(HARNESS) $(call source,$*) -lm

# The long run: make record-fuzz FUZZ_RUNS=10000000 writes what it found into verification/checks/RESULTS.md.
record-fuzz: $(if $(FUZZER),$(BUILDS:%=$(CHECKS)/fuzz-%),left-out/fuzz)
	cd .. && $(PYTHON) -m c_runtime.verification.checks.record_fuzz $(abspath $(EXPORTED)) --output c_runtime/verification/checks/RESULTS.md \
	    --options="-runs=$(FUZZ_RUNS) $(FUZZ_OPTIONS)" $(foreach b,$(BUILDS),$(b)=$(abspath $(CHECKS)/fuzz-$(b)))

# --- valgrind: no undefined value decides anything, in the unit tests and under the fuzz harness. ---
PACKAGES_valgrind = valgrind
MEMCHECK = valgrind --quiet --error-exitcode=9 --leak-check=no
# Where a value that is used came from takes a third more time: it is told only where something is found.
memcheck = $(MEMCHECK) $(1) >$(2) || { cat $(2); $(MEMCHECK) --track-origins=yes $(1) >/dev/null; false; }

valgrind: $(if $(call present,valgrind),$(BUILDS:%=valgrind/%),left-out/valgrind)
valgrind/%: $(CHECKS)/memcheck-test-% $(CHECKS)/memcheck-drive-%
	@$(call memcheck,$(CHECKS)/memcheck-test-$*,$(CHECKS)/memcheck-test-$*.txt)
	@$(call memcheck,$(CHECKS)/memcheck-drive-$* $(MEMCHECK_RUNS),$(CHECKS)/memcheck-drive-$*.txt)
	@echo "valgrind $*: no error in the unit tests and the inputs"
$(CHECKS)/memcheck-test-%: $(UNIT_TESTS) $(SOURCES) $(BATCH) verification/checks/checks.mk | $(CHECKS)
	@$(COMPILE) -g -O2 -DCASES=$(MEMCHECK_CASES) $(TESTED_$*) -o $@ $< $(BATCH) -lm
$(CHECKS)/memcheck-drive-%: $(DRIVER) $(SOURCES) verification/checks/checks.mk | $(CHECKS)
	@$(COMPILE) -g -O2 -DSAILNET_MEMCHECK $(DEFINES_$*) -o $@ $(DRIVER) $(call source,$*) -lm

# --- misra: cppcheck, and its MISRA C:2012 add-on against the deviations listed in MISRA.md, of what flies. ---
PACKAGES_misra = cppcheck
DEVIATIONS ?= MISRA.md

misra: $(if $(filter $(FLYING),$(BUILDS)),$(if $(call present,cppcheck),misra/all,left-out/misra))
misra/all: $(SOURCES)
	@cd .. && $(PYTHON) -m c_runtime.verification.checks.misra $(abspath $(EXPORTED)) $(abspath $(DEVIATIONS)) $(filter $(FLYING),$(BUILDS))

# --- coverage-c: every line and branch, by the unit tests and the fuzz harness. ---
PACKAGES_coverage-c = gcc
# Parts that would be inlined stay functions: else each call has branches of its own, decided by constants.
COVERAGE = $(GCC) -std=c99 $(WARNINGS) -Wno-attributes -O0 --coverage -Dalways_inline=noinline -I$(EXPORTED)
GAPS ?= verification/checks/coverage_gaps.toml

coverage-c: $(if $(call present,gcov),coverage/all,left-out/coverage-c)
coverage/all: $(BUILDS:%=coverage/%)
	@cd .. && $(PYTHON) -m c_runtime.verification.checks.coverage $(abspath $(EXPORTED)) $(abspath $(GAPS)) \
	    $(foreach b,$(BUILDS),$(b)=$(abspath $(CHECKS)/coverage-$(b)))
coverage/%: $(UNIT_TESTS) $(DRIVER) $(SOURCES) $(BATCH) | $(CHECKS)
	@rm -rf $(CHECKS)/coverage-$* && mkdir $(CHECKS)/coverage-$*
	@$(COVERAGE) $(TESTED_$*) -DCASES=$(COVERAGE_CASES) -c -o $(CHECKS)/coverage-$*/test.o $<
	@$(COVERAGE) $(DEFINES_$*) -c -o $(CHECKS)/coverage-$*/guidance.o $(call source,$*)
	@$(COMPILE) -O1 $(DEFINES_$*) -o $(CHECKS)/coverage-$*/test $(CHECKS)/coverage-$*/test.o $(BATCH) -lm -lgcov
	@$(COMPILE) -O1 $(DEFINES_$*) -o $(CHECKS)/coverage-$*/drive $(CHECKS)/coverage-$*/guidance.o $(DRIVER) -lm -lgcov
	@$(CHECKS)/coverage-$*/test >$(CHECKS)/coverage-$*/test.txt || { cat $(CHECKS)/coverage-$*/test.txt; false; }
	@$(CHECKS)/coverage-$*/drive $(COVERAGE_RUNS) >$(CHECKS)/coverage-$*/drive.txt

# --- warnings: none, as C99 and C++11/17, gcc and clang, 64 and 32 bit. ---
PACKAGES_warnings-clang = clang
PACKAGES_warnings-cxx = g++
PACKAGES_warnings-m32 = libc6-dev-i386
PACKAGES_warnings-gcc = gcc
# Not -Wfloat-equal: comparing a number with itself is how a NaN is told without libm.
STRICT = $(WARNINGS) -Wshadow -Wdouble-promotion -Wundef -Wcast-qual -Wcast-align -Wwrite-strings -ffreestanding -O2 \
    -I$(EXPORTED) -o /dev/null
AS_C = -std=c99 -Wstrict-prototypes -Wmissing-prototypes
X87_FREE = -m32 -msse2 -mfpmath=sse
on_x86 = $(filter x86_64,$(shell uname -m))
each_build = @set -e; $(foreach b,$(BUILDS),$(1) $(DEFINES_$(b)) $(STRICT) -c $(call source,$(b));) echo "$@: none"

warnings: $(if $(call present,$(GCC)),warnings-gcc,left-out/warnings-gcc) \
    $(if $(call present,$(CLANG)),warnings-clang,left-out/warnings-clang) \
    $(if $(call present,g++),warnings-cxx,left-out/warnings-cxx) \
    $(if $(on_x86),$(if $(call compiles,$(GCC) -m32),warnings-m32,left-out/warnings-m32))
.PHONY: warnings-gcc warnings-clang warnings-cxx warnings-m32
warnings-gcc: $(SOURCES)
	$(call each_build,$(GCC) $(AS_C))
warnings-clang: $(SOURCES)
	$(call each_build,$(CLANG) $(AS_C))
	$(call each_build,$(CLANG) -x c++ -std=c++11)
	$(call each_build,$(CLANG) -x c++ -std=c++17)
warnings-cxx: $(SOURCES)
	$(call each_build,g++ -x c++ -std=c++11)
	$(call each_build,g++ -x c++ -std=c++17)
warnings-m32: $(SOURCES)
	$(call each_build,$(GCC) $(X87_FREE) $(AS_C))
	$(if $(call present,$(CLANG)),$(call each_build,$(CLANG) $(X87_FREE) $(AS_C)))
