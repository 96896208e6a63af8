# What teachers do with the judge; README.md beside tells how. Not in the students' archive. Included by class.mk.

CLASS_UNPACK = $(BUILD)/class_unpack
CLASS_TABLE  = $(BUILD)/class_table

$(CLASS_UNPACK): $(call object,$(wildcard tests/class/unpack/*.c)) $(LIBRARY)
	$(call link,-larchive)

$(CLASS_TABLE): $(call object,$(wildcard tests/class/table/*.c) tests/judge/grade/points.c $(REPORT_WORDS)) $(LIBRARY)
	$(call link,-ljansson)

.PHONY: class class-slurm class-alike check-alike handout gradescope class-tools check-class check-class-many class-slurm-trial class-numbers

# What run_autograder compiles students' code with, where there is no make around it.
$(BUILD)/class_flags.sh: Makefile tests/steps/exercises.mk
	@mkdir -p $(@D)
	@printf "export PHOTONLAB_CC='%s' PHOTONLAB_FLAGS='%s' PHOTONLAB_LINK='%s'\n" '$(CC)' '$(STEP_FLAGS)' '$(PLUGIN)' >$@

class-tools: $(BUILD)/class_flags.sh judge $(WRITE_REPORTS) $(CLASS_UNPACK) $(CLASS_TABLE)

##teacher class  grade a class: [SALT=secret] make class DIR=submissions [ROSTER=roster.csv] [FORMAT=moodle|canvas] [GRADE=assignment] [OUT=build/class] [EARLIER=build/class-1] [REGRADE=1]
##teacher class-slurm  the same by a Slurm cluster, in parts: … make class-slurm DIR=submissions [SHARDS=64] …
class class-slurm: export PHOTONLAB_DIR = $(DIR)
class class-slurm: export PHOTONLAB_ROSTER = $(ROSTER)
class class-slurm: export PHOTONLAB_COLUMN = $(COLUMN)
class class-slurm: export PHOTONLAB_FORMAT = $(FORMAT)
class class-slurm: export PHOTONLAB_GRADE = $(GRADE)
class class-slurm: export PHOTONLAB_EARLIER = $(EARLIER)
class class-slurm: export PHOTONLAB_OUT = $(or $(OUT),$(BUILD)/class)
class class-slurm: export PHOTONLAB_REGRADE = $(REGRADE)
class class-slurm: export PHOTONLAB_PARALLEL_FLAGS = $(PARALLEL_FLAGS)
class class-slurm: class-tools
	$(if $(filter command,$(origin SALT)),$(error What stands behind `make`, students' code can read. Before it: SALT=secret make $@))
	@bash tests/class/$(subst -,_,$@).sh $(SHARDS)

# Python's copydetect, which compares code, in a folder of its own.
ALIKE = $(BUILD)/alike/bin/python
$(ALIKE):
	@echo "copydetect, from PyPI: some 200 MB, once"
	@rm -rf $(BUILD)/alike && { python3 -m venv $(BUILD)/alike && $(BUILD)/alike/bin/pip -q install copydetect==0.5.0; } || \
	    { rm -rf $(BUILD)/alike; echo "class-alike needs copydetect: python3-venv (on Debian: apt-get install python3-venv) and a way to PyPI" >&2; exit 1; }

##teacher class-alike  after make class: which submissions share more steps than chance would have it? [OUT=build/class]
class-alike: $(CLASS_UNPACK) $(ALIKE)
	@test -f $(call quoted,$(or $(OUT),$(BUILD)/class)/.parts/.list) || { echo "class-alike: make class comes first" >&2; exit 2; }
	@$(ALIKE) tests/class/alike.py . $(BUILD) $(call quoted,$(or $(OUT),$(BUILD)/class))

##teacher handout  the students' archive: make handout [OUT=build/handout] [WITH_SOLUTIONS=1] [VERSION=2]
handout: export PHOTONLAB_OUT = $(or $(OUT),$(BUILD)/handout)
handout: export PHOTONLAB_VERSION = $(VERSION)
handout: export PHOTONLAB_WITH_SOLUTIONS = $(WITH_SOLUTIONS)
handout: all $(CLASS_TABLE)
	+@$(ONLY_SHOWN) if $(MAKE) --no-print-directory tab-parts >$(BUILD)/tab.log 2>&1; then export PHOTONLAB_TAB=$(TAB); else \
	echo "without the browser's part (make preview WEB=1), which does not build here: see $(BUILD)/tab.log; make setup WEB=1"; fi; \
	bash tests/class/handout.sh

##teacher gradescope  the autograder for Gradescope: make gradescope [OUT=build/gradescope] [SALT=secret]
gradescope: export PHOTONLAB_OUT = $(or $(OUT),$(BUILD)/gradescope)
gradescope: $(CLASS_TABLE)
	@bash tests/class/gradescope.sh

##check beside check-class  submitting, updating, grading a small class, handout, autograder
check-class: class-tools meshes
	@bash tests/class/test/class.sh

##check long check-class-many  200 submissions in a locale with a decimal comma, killed half-way and begun again; COUNT=20
check-class-many: class-tools meshes
	@COUNT=$(COUNT) bash tests/class/test/many.sh $(BUILD)

##check long class-slurm-trial  make class-slurm on a cluster of this one machine
class-slurm-trial: class-tools
	@bash tests/class/slurm_trial.sh

##check long check-alike  make class-alike finds a copy with other names among right solutions; takes copydetect from PyPI
check-alike: $(CLASS_UNPACK) $(ALIKE)
	@bash tests/class/test/alike.sh $(ALIKE)

##teacher class-numbers  what a class costs, and its pages at ten thousand rows: tests/class/numbers.md
class-numbers: class-tools meshes
	@bash tests/class/numbers.sh
