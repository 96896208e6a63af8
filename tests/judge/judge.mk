# The judge, and what students do with it; included by the Makefile.

JUDGE         = $(BUILD)/judge
# What others than the reports say, too.
REPORT_WORDS  = tests/judge/report/text.c tests/judge/report/status.c
# What the kind of object files and the kernel decide.
OTHER_SYSTEMS = $(addprefix tests/judge/,$(if $(filter Linux,$(SYSTEM)),sandbox/sandbox_elsewhere.c,$(addprefix sandbox/sandbox_,filter.c landlock.c uid.c folder.c bubblewrap.c)) \
                    submission/object_$(if $(filter Darwin,$(SYSTEM)),elf,macho).c)
JUDGE_SOURCES := $(filter-out $(addprefix tests/judge/,calibrate/% probe/% report/%) $(OTHER_SYSTEMS),$(call find_c,tests/judge tests/steps)) \
                 $(REPORT_WORDS) $(addprefix tests/judge/report/,fields.c report_file.c words.c)
JUDGE_LIBS    = $(or $(if $(PKG),$(shell pkg-config --libs gsl jansson $(LIBSECCOMP) 2>/dev/null)),-lgsl -lgslcblas -ljansson $(LIBSECCOMP:lib%=-l%))
LIBSECCOMP    = $(if $(filter Linux,$(SYSTEM)),libseccomp)
WRITE_REPORTS = $(BUILD)/write_reports

$(JUDGE): $(call object,$(JUDGE_SOURCES)) $(LIBRARY)
	$(call link,$(JUDGE_LIBS))

# What runs students' code for the judge, in the sandbox.
PROBE = $(BUILD)/probe
$(PROBE): $(call object,$(wildcard tests/judge/probe/*.c)) $(LIBRARY)
	$(call link)

$(WRITE_REPORTS): $(call object,$(wildcard tests/judge/report/*.c)) $(LIBRARY)
	$(call link,-ljansson)

.PHONY: judge test test-sanitized report finale debug
judge: all $(JUDGE) $(PROBE)

JUDGE_RUN = $(JUDGE) --build $(BUILD) --work $(BUILD)/test --code $(call quoted,$(CODE)) $(if $(STEP),--step $(call quoted,$(STEP))) \
            $(if $(STAGE),--stage $(call quoted,$(STAGE))) $(if $(filter 1,$(STRICT)),--strict) $(JUDGE_FLAGS)

# By the environment: what stands on a command line, anybody on the machine can read.
export PHOTONLAB_SALT = $(SALT)

## test  grade your work: make test [STAGE=2] [STEP=2.1] [CODE=another-directory]
test: judge
	@$(JUDGE_RUN)

## report  the same, with your pictures: build/report/index.html; junit.xml and others
report: judge $(WRITE_REPORTS)
	@$(JUDGE_RUN) --report $(BUILD)/report; code=$$?; \
	$(WRITE_REPORTS) $(if $(wildcard $(BUILD)/notes/index.html),--notes ../notes) \
	    $(if $(wildcard $(BUILD)/finale/finale.png),--finale ../finale/finale.png) $(BUILD)/report && \
	$(if $(wildcard $(BUILD)/notes/index.html),:,echo "(after \`make notes\` its chapters are links)") && exit $$code

## finale  all green? The course's picture by your code, in a frame: build/finale/finale.png [NAME=you] [SIDE=768]
# All that the course asks for, whatever STEP and STAGE are; a step that is not started would be the reference's.
finale: override STRICT = 1
finale: override STEP =
finale: override STAGE =
finale: export PHOTONLAB_NAME = $(NAME)
finale: export PHOTONLAB_PLAYED = $(CODE_BUILD)
finale: export PHOTONLAB_SIDE = $(or $(SIDE),768)
finale: judge meshes code-built
	@bash tests/judge/finale.sh $(JUDGE_RUN)

## debug  gdb on the case that failed: make debug STEP=2.1
debug: judge
	@test -n $(call quoted,$(STEP)) || { echo "say which step: make debug STEP=2.1"; exit 2; }
	@$(MAKE) --no-print-directory test STEP_OPTIMISE=-O0 || true
	@sh tests/judge/debug.sh $(BUILD) $(call quoted,$(STEP))

## test-sanitized  the test under sanitizers, which see what did not crash by luck: STEP=2.1
test-sanitized:
	+@$(SANITIZED) STEP_OPTIMISE=-O1 JUDGE_FLAGS="--sanitized --seconds 60" test
