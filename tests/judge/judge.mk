# The judge and what students and teachers do with it; included by the Makefile.

JUDGE         = $(BUILD)/judge
REPORT_WORDS  = tests/judge/report/text.c tests/judge/report/status.c
JUDGE_SOURCES := $(filter-out %/test_sandbox.c,$(wildcard tests/judge/*.c) $(call find_c,$(addprefix tests/judge/,checks grade sandbox scatter submission) tests/steps)) \
                 $(REPORT_WORDS) $(addprefix tests/judge/report/,fields.c report_file.c words.c)
JUDGE_LIBS    = $(or $(if $(PKG),$(shell pkg-config --libs gsl jansson libseccomp 2>/dev/null)),-lgsl -lgslcblas -ljansson -lseccomp)

$(JUDGE): $(call object,$(JUDGE_SOURCES)) $(LIBRARY)
	$(call say,link,$@)
	$(Q)$(CC) $(CFLAGS) $(filter %.o,$^) -L$(BUILD) -lphotonlab -Wl,-rpath,'$(ORIGIN)' -o $@ $(JUDGE_LIBS) $(LDLIBS)

# What runs students' code for the judge, in the sandbox.
PROBE = $(BUILD)/probe
$(PROBE): $(call object,$(wildcard tests/judge/probe/*.c)) $(LIBRARY)
	$(call say,link,$@)
	$(Q)$(CC) $(CFLAGS) $(filter %.o,$^) -L$(BUILD) -lphotonlab -Wl,-rpath,'$(ORIGIN)' -o $@ $(LDLIBS)

.PHONY: judge test
judge: all $(JUDGE) $(PROBE)

# How a student's step is compiled: with debug information, with the warnings that help, and the same arithmetic everywhere.
STEP_OPTIMISE ?= -O2
STEP_FLAGS = -std=c99 -D_DEFAULT_SOURCE -D_XOPEN_SOURCE=700 -Wall -Wextra -ffp-contract=off -fno-math-errno $(STEP_OPTIMISE) -g -fPIC


JUDGE_RUN = $(JUDGE) --build $(BUILD) --work $(BUILD)/test --compiler $(CC) --flags "$(STEP_FLAGS)" --link "$(PLUGIN)" \
            --code "$(CODE)" $(if $(STEP),--step $(STEP)) $(if $(STAGE),--stage $(STAGE)) $(if $(SALT),--salt "$(SALT)") \
            $(if $(filter 1,$(STRICT)),--strict) $(JUDGE_FLAGS)

## test            grade your work: make test [STAGE=2] [STEP=2.1] [CODE=another-directory]
test: judge
	@$(JUDGE_RUN)

## test-sanitized  the same under AddressSanitizer and UBSan, which see what did not crash by luck: make test-sanitized STEP=2.1
.PHONY: test-sanitized
test-sanitized:
	@$(SANITIZED) STEP_OPTIMISE="-O1 -fsanitize=address,undefined -fno-sanitize-recover=undefined" CODE="$(CODE)" STEP="$(STEP)" STAGE="$(STAGE)" \
	    PLUGIN="$(PLUGIN) -fsanitize=address,undefined" JUDGE_FLAGS="--sanitized --seconds 60" test

## report          the same, and build/report/: index.html with your pictures, junit.xml, report.tap, results for Gradescope and PrairieLearn
WRITE_REPORTS = $(BUILD)/write_reports
report: judge $(WRITE_REPORTS)
	@$(JUDGE_RUN) --report $(BUILD)/report; code=$$?; \
	$(WRITE_REPORTS) $(if $(wildcard $(BUILD)/notes/index.html),--notes ../notes) $(BUILD)/report && \
	$(if $(wildcard $(BUILD)/notes/index.html),:,echo "(after \`make notes\` its chapters are links)") && exit $$code

REPORT_SOURCES = $(wildcard tests/judge/report/*.c)
$(WRITE_REPORTS): $(call object,$(REPORT_SOURCES)) $(LIBRARY)
	$(call say,link,$@)
	$(Q)$(CC) $(CFLAGS) $(filter %.o,$^) -L$(BUILD) -lphotonlab -Wl,-rpath,'$(ORIGIN)' -o $@ -ljansson $(LDLIBS)

$(BUILD)/tests/print_sample: $(call object,tests/judge/report/test/print_sample.c tests/judge/print.c $(REPORT_WORDS)) $(LIBRARY)
	@mkdir -p $(@D)
	$(Q)$(CC) $(CFLAGS) $(filter %.o,$^) -L$(BUILD) -lphotonlab -Wl,-rpath,'$(ORIGIN)/..' -o $@ $(LDLIBS)

##   check-reports     every report format by its own schema
.PHONY: check-reports
check-reports: $(WRITE_REPORTS) $(BUILD)/tests/print_sample
	@bash tests/judge/report_test.sh $^

SANDBOX_OBJECTS = $(call object,tests/judge/sandbox/test_sandbox.c $(wildcard tests/judge/sandbox/sandbox*.c) lib/base/error.c)
$(BUILD)/tests/test_sandbox: $(SANDBOX_OBJECTS)
	@mkdir -p $(@D)
	$(Q)$(CC) $(CFLAGS) $(SANDBOX_OBJECTS) -o $@ -lseccomp $(LDLIBS)

## bench-test      how long `make test` takes, against its limits
.PHONY: bench-test
bench-test: judge
	@bash tests/bench/judge.sh $(BUILD)

## calibrate       what right code's pictures are like: tests/reference/pictures/ (ten minutes of processor time)
.PHONY: calibrate
CALIBRATE_OBJECTS = $(call object,$(wildcard tests/judge/calibrate/*.c) tests/judge/checks/pictures.c tests/judge/checks/picture_statistics.c \
                      tests/judge/checks/plan.c tests/judge/checks/statistics.c)
$(BUILD)/calibrate: $(CALIBRATE_OBJECTS) $(LIBRARY)
	$(call say,link,$@)
	$(Q)$(CC) $(CFLAGS) $(CALIBRATE_OBJECTS) -L$(BUILD) -lphotonlab -Wl,-rpath,'$(ORIGIN)' -o $@ $(JUDGE_LIBS) $(LDLIBS)
calibrate: all $(PROBE) $(BUILD)/calibrate
	@$(BUILD)/calibrate

##   check-pictures    how often right pictures are called wrong, and which mistakes pictures show (half an hour)
.PHONY: check-pictures
check-pictures: all $(PROBE) $(BUILD)/calibrate
	@sh tests/judge/picture_test.sh $(BUILD)

##   check-judge       what a student meets at the terminal
.PHONY: check-judge
check-judge: judge
	@bash tests/judge/judge_test.sh $(BUILD) $(CC) "$(STEP_FLAGS)" "$(PLUGIN)"

##   check-scatter     which known mistakes the stages' scatters show, and how often right code is called wrong (ten minutes)
.PHONY: check-scatter
check-scatter: judge
	@bash tests/judge/scatter_power_test.sh $(BUILD) $(CC) "$(STEP_FLAGS)" "$(PLUGIN)"
	@$(JUDGE_RUN) --code solutions --first-round --scatters 300 | awk '{ all++; wrong += $$2 != "pass" } \
	    END { printf "right code: %d of %d scatters differ in the first round\n", wrong, all }'

##   check-sandbox     what the sandbox keeps in, keeps out and reports
##   check-attacks     every attack costs its step, and nothing else
.PHONY: check-sandbox check-attacks
check-sandbox: $(BUILD)/tests/test_sandbox
	@$<

ATTACKS = . $(BUILD) $(JUDGE) --build $(BUILD) --compiler $(CC) --flags "$(STEP_FLAGS)" --link "$(PLUGIN)" --seconds 2
check-attacks: judge $(WRITE_REPORTS)
	@bash tests/attacks/both.sh $(ATTACKS)

## debug           gdb on the case that failed: make debug STEP=2.1
debug: judge
	@test -n "$(STEP)" || { echo "say which step: make debug STEP=2.1"; exit 2; }
	@$(MAKE) --no-print-directory test STEP="$(STEP)" STEP_OPTIMISE=-O0 || true
	@sh tests/judge/debug.sh $(BUILD) $(STEP)

.PHONY: report debug
