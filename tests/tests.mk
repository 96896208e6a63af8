# The project's own tests and benchmarks; included by the Makefile, and not in the students' archive. A target becomes a part of
# `make check` by its line: "##check WHEN NAME  words". WHEN is `first` (one after the other), `beside` (waits more than it works:
# two of these at once beside those), `alone` (counts seconds: at the end) or `long` (by hand only). tests/check.sh says CHECK=1: do
# no more than `make check` has time for, and let no warning pass.

-include tests/mistakes/grader.mk tests/scene_page/scene_page.mk tests/elsewhere/elsewhere.mk tests/export/export.mk

TEST_SOURCES  = $(filter-out $(if $(HAVE_PREVIEW),,tests/unit/preview/%),$(call find_c,tests/unit))
TESTS         = $(TEST_SOURCES:tests/unit/%.c=$(BUILD)/tests/%)
PREVIEW_TESTS = $(filter $(BUILD)/tests/preview/%,$(TESTS))

$(TESTS): $(BUILD)/tests/%: $(BUILD)/obj/tests/unit/%.o $(LIBRARY)
	$(call link,-lcmocka)
$(PREVIEW_TESTS): $(call object,$(PREVIEW_SOURCES))
$(BUILD)/obj/tests/unit/%.o: OPTIMISE = -O1

.PHONY: check-saves check-threads check-shortage check-build check-unit check-sanitized check-compilers check-bytes check-cli check-cli-sanitized check-probe check-exercises \
        check-preview check-judge check-reports check-attacks check-sandbox check-scatter check-pictures check-arm check-same check-rooms check-extend \
        reference reference-progressive agreement spectra calibrate exercises bench bench-test bench-preview fuzz size format

# Before all others, which then build nothing twice.
check-build: judge class-tools meshes

##check first check-rooms  which folder includes which: as lib/README.md and tests/README.md say?
check-rooms:
	@bash tests/rooms_test.sh

##check long check-extend  what a stage, a material, a view, a key costs; TRIAL=view (ten minutes)
check-extend:
	@bash tests/extend/run.sh $(call quoted,$(TRIAL))

##check first check-unit  the library's unit tests
check-unit: all meshes $(TESTS)
	@bash tests/unit/run.sh $(TESTS)

##check first check-sanitized  the same under sanitizers (in make check without the preview's)
check-sanitized: meshes
	+@$(SANITIZED) check-unit

##check first check-bytes  no warning by gcc or clang; by both, on 1, 2 and 7 threads, the same bytes
# What gcc has built already it need not build again; `make check` has it build with -Werror from the start.
GCC_BUILD = $(if $(filter gcc,$(notdir $(CC))),$(BUILD),$(BUILD)/gcc)
check-compilers:
	@$(MAKE) BUILD=$(GCC_BUILD) CC=gcc CHECK=1 all $(TEST_SOURCES:tests/unit/%.c=$(GCC_BUILD)/tests/%)
	@$(MAKE) BUILD=$(BUILD)/clang CC=clang OPTIMISE=-O2 EXTRA="-Werror -g0" HAVE_PREVIEW= all
	$(Q)printf '%s\n' $(TEST_SOURCES) $(PREVIEW_SOURCES) $(call find_c,$(addprefix tests/,fuzz judge steps class)) | \
	    xargs -n 8 -P $(shell getconf _NPROCESSORS_ONLN) clang $(STANDARD) -Wno-c11-extensions $(OPENMP) -Werror -fsyntax-only -Ilib -Itests $(PKG_CFLAGS)
	$(Q)gcc $(STANDARD) $(OPENMP) -Werror -fsyntax-only -Ilib -Itests $(PKG_CFLAGS) $(wildcard tests/fuzz/*.c)
check-bytes: check-compilers meshes
	@bash tests/same_bytes.sh $(GCC_BUILD)/photonlab $(BUILD)/clang/photonlab

##check first check-cli  the command line: exit codes, messages, students' steps
check-cli: all
	@bash tests/cli.sh $(PROGRAM) $(BUILD)

##check first check-cli-sanitized  the same under sanitizers
check-cli-sanitized: meshes
	+@$(SANITIZED) check-cli

##check first check-probe  what the judge asks of a step, in numbers
check-probe: all $(PROBE)
	@bash tests/probe.sh $(PROGRAM) $(BUILD)

##check first check-exercises  exercises/ is what solutions/ gives, and nothing in it is solved
check-exercises: all
	@PROGRAM='$(PROGRAM)' bash tests/steps/make_exercises.sh check

##maintainer exercises  the empty steps as solutions/ gives them; what was worked on stays
exercises:
	@bash tests/steps/make_exercises.sh write

##check beside check-preview  the window: faults, keys, the same bytes from OSMesa, EGL and GLFW
check-preview: judge meshes
	@bash tests/preview/check.sh $(PROGRAM) $(BUILD) $(STEP_COMMAND) $(FEW)

##check long check-threads  all scenes in all ways on 2 to 13 threads: the same bytes; and no race, by ThreadSanitizer (half an hour)
check-threads: all meshes
	@bash tests/threads.sh $(PROGRAM) 2 3 4 5 7 8 11 13
	@$(MAKE) BUILD=$(BUILD)/threads CC=clang OPTIMISE=-O1 HAVE_PREVIEW= EXTRA=-fsanitize=thread all
	@bash tests/threads.sh $(BUILD)/threads/photonlab 3

##check long check-shortage  each allocation fails in turn: pictures, files, snapshots; EVERY=7 for every seventh (ten minutes)
check-shortage: all meshes
	@EVERY=$(EVERY) bash tests/shortage/run.sh $(PROGRAM)

##check long check-saves  10,000 saves in one window, its helper killed and stopped, a full /tmp; SAVES=100
check-saves: all meshes
	@SAVES=$(SAVES) bash tests/preview/saves.sh $(PROGRAM) $(BUILD) $(STEP_COMMAND)

##check beside check-attacks  every attack costs its step, and nothing else
# make check has no time for all three: each attack meets one of two there. check-sandbox asks each.
ATTACKS = . $(BUILD) $(JUDGE) --build $(BUILD) --credit --seconds 1
check-attacks: judge $(WRITE_REPORTS)
	@$(if $(CHECK),EVERY=2 SANDBOXES="uid bubblewrap") bash tests/attacks/everywhere.sh $(ATTACKS)

##check beside check-reports  every report format by its own schema
$(BUILD)/tests/print_sample: $(call object,tests/judge/report/test/print_sample.c tests/judge/print.c tests/judge/terminal.c $(REPORT_WORDS)) $(LIBRARY)
	$(call link)
check-reports: $(WRITE_REPORTS) $(BUILD)/tests/print_sample
	@bash tests/judge/report/test/report.sh $^

##check beside check-judge  what a student meets at the terminal
check-judge: judge $(BUILD)/calibrate
	@bash tests/judge/judge_test.sh

##check alone check-sandbox  what the sandbox keeps in, keeps out and reports
# Runs itself in the sandbox, where it sees no library of ours.
$(BUILD)/tests/test_sandbox: $(call object,$(filter-out $(OTHER_SYSTEMS),$(wildcard tests/judge/sandbox/*.c tests/judge/sandbox/test/*.c)) lib/base/error.c)
	$(call beside,$(CC) $(CFLAGS) $^ -o $$new -lcmocka -lseccomp $(LDLIBS))
check-sandbox: $(BUILD)/tests/test_sandbox
	@bash tests/unit/run.sh $<

##check first reference  all integrators against an independent renderer's images (SCENES=few: as make check does)
FEW = $(if $(CHECK),few,$(SCENES))
reference: all
	@bash tests/reference/compare.sh $(PROGRAM) $(FEW)

##check long reference-progressive  the error of passes: how it falls; a table for a figure, build/progressive.txt (ten minutes)
reference-progressive: all meshes
	@bash tests/reference/progressive.sh $(PROGRAM) $(BUILD)/progressive.txt

##check first agreement  photons against the path tracer (SCENES=few: as make check does)
agreement: all meshes
	@bash tests/agreement.sh $(PROGRAM) $(FEW)

##maintainer spectra  photons of single wavelengths against a spectral sum, three bands beside them, what hero wavelengths gain
$(BUILD)/reflectances: $(call object,tests/spectra/reflectances.c) $(LIBRARY)
	$(call link)
spectra: all $(BUILD)/reflectances
	@bash tests/spectra.sh $(PROGRAM) $(BUILD)/reflectances

##check long check-scatter  which mistakes the scatters show, and false verdicts (ten minutes)
check-scatter: judge
	@bash tests/judge/scatter_power_test.sh
	@$(JUDGE_RUN) --code solutions --first-round --scatters 300 | awk '{ all++; wrong += $$2 != "pass" } \
	    END { printf "right code: %d of %d scatters differ in the first round\n", wrong, all }'

##check long check-pictures  which mistakes pictures show, and false verdicts (two hours of two cores; stage 4 the most)
check-pictures: all $(PROBE) $(BUILD)/calibrate
	@sh tests/judge/picture_test.sh $(BUILD)

##maintainer calibrate  what right pictures are like: tests/reference/pictures/ (half an hour)
$(BUILD)/calibrate: $(call object,$(wildcard tests/judge/calibrate/*.c) $(addprefix tests/judge/checks/,pictures.c picture_statistics.c plan.c \
                        statistics.c)) $(LIBRARY)
	$(call link,$(JUDGE_LIBS))
calibrate: all $(PROBE) $(BUILD)/calibrate
	@$(BUILD)/calibrate

##check long check-arm  unit tests on an emulated aarch64, and a picture to the byte
# On Debian it needs gcc-aarch64-linux-gnu, qemu-user, and the libraries of `make setup` with :arm64.
ARM = BUILD=$(BUILD)/arm CC=aarch64-linux-gnu-gcc PKG_CFLAGS= PKG_LIBS="-lpng -lyaml"
PICTURE = render scenes/box_glass.yaml --size 97x61 --photons 60000 --samples 3 --quiet
check-arm: all meshes
	@RUNNER="qemu-aarch64 -L /" $(MAKE) $(ARM) check-unit
	@qemu-aarch64 -L / $(BUILD)/arm/photonlab $(PICTURE) -o $(BUILD)/arm/there.pfm
	@$(PROGRAM) $(PICTURE) -o $(BUILD)/arm/here.pfm
	@cmp $(BUILD)/arm/there.pfm $(BUILD)/arm/here.pfm && echo "the same picture to the byte"

##check long check-same  another commit's output and this one's: the same bytes? AS=COMMIT
check-same: judge meshes
	@bash tests/same_as.sh "$${AS:?says which commit}" $(BUILD)

$(BUILD)/bench_photons: $(call object,tests/bench/photons.c lib/cli/common.c lib/cli/guard.c) $(LIBRARY)
	$(call link)

##maintainer bench  speed against other programs, side by side (installs them first)
bench: all meshes
	@bash tests/bench/run.sh

##maintainer bench-test  how long `make test` takes, against its limits
bench-test: judge
	@bash tests/bench/judge.sh $(BUILD)

##maintainer bench-preview  how soon after a save the photons are there, frames a second
bench-preview: all meshes judge
	@bash tests/bench/preview.sh $(PROGRAM) $(BUILD) $(STEP_COMMAND)

##maintainer fuzz  feed a reader with nonsense: READER=scene|…|all SECONDS=600 of a processor; tests/fuzz/ has a file for each
READER  ?= scene
SECONDS ?= 60
FUZZERS  = $(patsubst tests/fuzz/fuzz_%.c,%,$(wildcard tests/fuzz/fuzz_*.c))
FUZZED   = $(MAKE) BUILD=$(BUILD)/fuzz CC=clang OPTIMISE=-O1 OPENMP= HAVE_PREVIEW= \
           EXTRA="-fsanitize=fuzzer-no-link,address,undefined -fno-sanitize-recover=undefined -Wno-unused-parameter"
# What they call beside the library; without an OpenMP their runs repeat.
$(BUILD)/fuzzed.a: $(call object,$(filter-out tests/judge/judge.c tests/judge/report/main.c tests/class/table/class_table.c,$(sort $(JUDGE_SOURCES) \
                       $(wildcard tests/judge/report/*.c tests/class/table/*.c))))
	$(call beside,ar rcs $$new $^)
$(BUILD)/fuzz_%: $(BUILD)/obj/tests/fuzz/fuzz_%.o $(BUILD)/fuzzed.a $(LIBRARY) $(STEPS)
	$(call link,$(BUILD)/fuzzed.a -fsanitize=fuzzer $(JUDGE_LIBS))
fuzz: judge meshes $(SCENE_PAGE)
	+@$(FUZZED) $(patsubst %,$(BUILD)/fuzz/fuzz_%,$(if $(filter all,$(READER)),$(FUZZERS),$(READER))) || \
	    { echo "READER is one of: $(FUZZERS). Does clang lack its fuzzer? make setup fuzz"; exit 1; }
	@bash tests/fuzz/fuzz.sh $(BUILD) $(SECONDS) $(if $(filter all,$(READER)),$(FUZZERS),$(READER))

##maintainer size  lines of C and shell, room by room: make size [OF=COMMIT]
size:
	@sh tests/size.sh $(call quoted,$(OF))

##maintainer format  lay the C files out by .clang-format
format:
	clang-format -i $$(git ls-files '*.c' '*.h' '*.cpp')
