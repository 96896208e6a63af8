# Takes the reference steps as they were built for the handout, since their sources are not in it. Included by the
# Makefile.

ifeq ($(wildcard solutions/*/*.c),)
.DEFAULT_GOAL := all
PREBUILT      := prebuilt/$(shell uname -m)-$(SYSTEM)/solutions
PREBUILT_FOR  := $(subst -, ,$(notdir $(wildcard prebuilt/*-*)))
STEPS          = $(or $(patsubst $(PREBUILT)/%,$(BUILD)/solutions/%,$(wildcard $(PREBUILT)/*/*.so)),no-reference)

$(BUILD)/solutions/%.so: $(PREBUILT)/%.so
	$(call beside,cp $< $$new)

.PHONY: no-reference
no-reference:
	@echo "The reference steps in this archive were built for: $(PREBUILT_FOR)." >&2
	@echo "This is $$(uname -m) $(SYSTEM), where they do not run. Ask your teacher for an archive made on such a machine" >&2
	@echo "(make handout), or for one with the sources (make handout WITH_SOLUTIONS=1); or work on $(PREBUILT_FOR)." >&2
	@false
endif
