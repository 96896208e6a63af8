# What teachers do with the judge; README.md beside tells how. Not in the students' archive. Included by class.mk.

CLASS_UNPACK = $(BUILD)/class_unpack
CLASS_TABLE  = $(BUILD)/class_table

$(CLASS_UNPACK): $(call object,$(wildcard tests/class/unpack/*.c)) $(LIBRARY)
	$(call link,-larchive)

$(CLASS_TABLE): $(call object,$(wildcard tests/class/table/*.c) $(REPORT_WORDS)) $(LIBRARY)
	$(call link,-ljansson)

.PHONY: class handout gradescope class-tools check-class class-trial

# What run_autograder compiles students' code with, where there is no make around it.
$(BUILD)/class_flags.sh: Makefile tests/steps/exercises.mk
	@mkdir -p $(@D)
	@printf "export PHOTONLAB_CC='%s' PHOTONLAB_FLAGS='%s' PHOTONLAB_LINK='%s'\n" '$(CC)' '$(STEP_FLAGS)' '$(PLUGIN)' >$@

class-tools: $(BUILD)/class_flags.sh judge $(WRITE_REPORTS) $(CLASS_UNPACK) $(CLASS_TABLE)

##teacher class  grade a class: [SALT=secret] make class DIR=submissions [ROSTER=roster.csv] [OUT=build/class] [REGRADE=1] [PARALLEL_FLAGS=…]
class: export PHOTONLAB_DIR = $(DIR)
class: export PHOTONLAB_ROSTER = $(ROSTER)
class: export PHOTONLAB_COLUMN = $(COLUMN)
class: export PHOTONLAB_OUT = $(or $(OUT),$(BUILD)/class)
class: export PHOTONLAB_REGRADE = $(REGRADE)
class: export PHOTONLAB_PARALLEL_FLAGS = $(PARALLEL_FLAGS)
class: class-tools
	$(if $(filter command,$(origin SALT)),$(error What stands behind `make`, students' code can read. Before it: SALT=secret make class))
	@bash tests/class/class.sh

##teacher handout  the students' archive: make handout [OUT=build/handout] [WITH_SOLUTIONS=1] [VERSION=2]
handout: export PHOTONLAB_OUT = $(or $(OUT),$(BUILD)/handout)
handout: export PHOTONLAB_VERSION = $(VERSION)
handout: export PHOTONLAB_WITH_SOLUTIONS = $(WITH_SOLUTIONS)
handout: all
	@bash tests/class/handout.sh

##teacher gradescope  the autograder for Gradescope: make gradescope [OUT=build/gradescope] [SALT=secret]
gradescope: export PHOTONLAB_OUT = $(or $(OUT),$(BUILD)/gradescope)
gradescope:
	@bash tests/class/gradescope.sh

##check beside check-class  submitting, updating, grading a small class, handout, autograder
check-class: class-tools meshes
	@bash tests/class/test_class.sh

##check long class-trial  200 submissions made of known answers, with a kill half-way
class-trial: class-tools
	@bash tests/class/trial.sh
