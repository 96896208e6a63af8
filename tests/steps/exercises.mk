# Students' code: how it is built, and what students do with it. Included by the Makefile.
#
# CODE is the folder with the student's files, laid out as exercises/. Its objects go to CODE_BUILD, one folder for each CODE, so
# that two submissions never mix.
CODE ?= exercises
ifeq ($(or $(patsubst %/,%,$(CODE)),exercises),exercises)
CODE_SOURCE := exercises
CODE_BUILD   = $(BUILD)/exercises
else
CODE_QUOTED := $(call quoted,$(patsubst %/,%,$(CODE)))
CODE_KEY    := $(shell cd $(CODE_QUOTED) 2>/dev/null && pwd -P | cksum | tr ' ' -)
CODE_BUILD   = $(BUILD)/code/$(CODE_KEY)
# A name that make would stumble over, with a blank in it say, is gone round by a link.
CODE_SOURCE := $(if $(CODE_KEY),$(shell cd $(CODE_QUOTED) && case $(CODE_QUOTED) in \
                 (*[!A-Za-z0-9._/-]*) link=$(call quoted,$(abspath $(BUILD))/code/$(CODE_KEY)/source); mkdir -p "$${link%/source}"; \
                     ln -sfn "`pwd -P`" "$$link"; echo '$(BUILD)/code/$(CODE_KEY)/source';; \
                 (*) echo $(CODE_QUOTED);; esac))
endif
# Steps alone; what else ends in .c there is to be included, or a copy.
STEP_FILES   := $(patsubst exercises/.stubs/%,%,$(wildcard exercises/.stubs/*/*.c))
CODE_OBJECTS := $(patsubst $(CODE_SOURCE)/%.c,$(CODE_BUILD)/%.so,$(wildcard $(addprefix $(CODE_SOURCE)/,$(STEP_FILES))))

# How a step is compiled, the same in preview, render, test, submit and a class: with debug information, every warning, and the
# arithmetic of the library. The judge and the scripts of tests/ find it in the environment.
STEP_OPTIMISE ?= -O2
STEP_FLAGS     = $(STANDARD) $(STEP_OPTIMISE) -g -fPIC $(filter-out -Werror,$(EXTRA))
export PHOTONLAB_BUILD = $(BUILD)
export PHOTONLAB_CC    = $(CC)
export PHOTONLAB_FLAGS = $(STEP_FLAGS)
export PHOTONLAB_LINK  = $(PLUGIN) $(filter -fsanitize%,$(EXTRA))

# For a shell: the source $1 becomes the object $2. Two previews may build the same one. STEP_COMMAND is the same as one word.
STEP_COMPILE = mkdir -p "$${2%/*}" && $(CC) $(STEP_FLAGS) -Ilib $(PLUGIN) -MMD -MP -MT "$$2" -MF "$${2%.so}.d" "$$1" -o "$$2.new$$$$" && mv "$$2.new$$$$" "$$2"
STEP_COMMAND = $(call quoted,$(STEP_COMPILE))

# A file that does not compile loses its object, so that the reference plays there and not what compiled yesterday. It is no
# error for make: the other steps go on.
define BUILD_STEP
	$(call say,cc,$<)
	$(Q)set -- '$<' '$@'; $(STEP_COMPILE) || \
	    { rm -rf $@ $@.new*; echo "  ✗ $< does not compile; the reference plays in its place"; }
endef

$(BUILD)/exercises/%.so: exercises/%.c
	$(BUILD_STEP)

ifneq ($(CODE_SOURCE),exercises)
$(CODE_BUILD)/%.so: $(CODE_SOURCE)/%.c
	$(BUILD_STEP)
endif

-include $(wildcard $(CODE_BUILD)/*/*.d)

# Objects whose source is gone must not play either.
.PHONY: code-built exercises-built code-there
code-there:
	@test -n "$(CODE_SOURCE)" || { echo $(call quoted,CODE=$(CODE): no such folder) >&2; exit 2; }
	@for so in $(CODE_BUILD)/*/*.so; do \
	    c=$${so#$(CODE_BUILD)/}; c=$${c%.so}.c; \
	    { [ -e "$(CODE_SOURCE)/$$c" ] && [ -e "exercises/.stubs/$$c" ]; } || rm -f "$$so"; done
	@mkdir -p $(CODE_BUILD); touch $(CODE_BUILD)/strays; for c in $(CODE_SOURCE)/[0-9]*_*/*.c; do \
	    name=$${c#$(CODE_SOURCE)/}; [ ! -e "$$c" ] || [ -e "exercises/.stubs/$$name" ] || grep -qxF "$$name" $(CODE_BUILD)/strays || \
	    { echo "$$name" >>$(CODE_BUILD)/strays; echo "  $$c is no step and does not play by itself"; }; done
code-built: code-there $(CODE_OBJECTS)
exercises-built: code-built

.PHONY: hint reset

## hint  a hint for a step, each call one that tells more: make hint STEP=2.1
hint: $(PROGRAM)
	@sh tests/steps/hint.sh $(PROGRAM) "$$STEP" $(BUILD)

## reset  the empty step again; your file is kept beside it: make reset STEP=2.1
reset:
	@sh tests/steps/reset.sh "$$STEP"
