# The live preview; included by the Makefile. lib/preview/ belongs to the program, not to the library: steps never draw.

# STAGE chooses the scene, where SCENE does not: one in which all of its steps play, mirror and glass of stage 1 too. A course of
# fewer stages has empty steps for these alone.
STAGES          := $(words $(wildcard exercises/.stubs/*/))
STAGE_SCENES    := $(wordlist 1,$(STAGES),$(shell sed -n 's/^STAGE.\([0-9]*\), *"\(.*\)".*/\1=\2/p' lib/steps/steps.def))
PREVIEW_SCENE    = $(if $(filter undefined file,$(origin SCENE)),$(or $(patsubst $(or $(STAGE),1)=%,%,$(filter $(or $(STAGE),1)=%,$(STAGE_SCENES))),$(error STAGE=$(STAGE): expected one of $(foreach s,$(STAGE_SCENES),$(firstword $(subst =, ,$(s)))))),$(SCENE))
PREVIEW_SNAPSHOT = $(BUILD)/preview.png

# What a stage is about is what its preview renders; its own scene is left with its steps.
STAGE_FLAGS      = --stages $(STAGES) $(if $(filter undefined file,$(origin SCENE)),--stage $(or $(STAGE),1))
PREVIEW_JUDGE    = $(call quoted,exec nice $(JUDGE) --build $(BUILD) --work $(BUILD)/verdicts --code $(call quoted,$(CODE)) --jobs 1 --lines --step "$$1" 2>&1)
PREVIEW_FLAGS    = --code '$(CODE_BUILD)' --watch $(call quoted,$(CODE_SOURCE)) --build $(STEP_COMMAND) --report '$(BUILD)/report/index.html'

.PHONY: preview snapshot

## preview  your photons, new after every save, and the step judged beside: make preview [STAGE=3] [SCENE=scenes/prism.yaml] [WEB=1: in the browser]
# Where the judge cannot be built, for want of a library say, the window goes without. Without a display, and without OpenGL for pictures, the
# browser is what is left; WEB=0 asks for the window all the same.
WEB_OF_ITSELF = if [ -z "$(HAVE_PREVIEW)" ] || { [ -z "$$DISPLAY$$WAYLAND_DISPLAY" ] && [ $(SYSTEM) = Linux ] && \
    ! $(PROGRAM) preview scenes/box_diffuse.yaml --photons 1 --snapshot '$(BUILD)/no_display.png' >/dev/null 2>&1; }; then \
    echo "There is no OpenGL here, and no display: your photons come to the browser."; web=1; fi
preview: all meshes code-built
	@[ -x $(JUDGE) ] || echo "  building the judge"
	+@$(ONLY_SHOWN) if $(MAKE) --no-print-directory judge >$(BUILD)/judge.log 2>&1; then set -- --judge $(PREVIEW_JUDGE); \
	else echo "the judge does not build here, see $(BUILD)/judge.log: the preview judges nothing"; set --; fi; \
	web='$(WEB)'; [ -n "$$web" ] || { $(WEB_OF_ITSELF); }; \
	if [ "$${web:-0}" != 0 ]; then $(MAKE) --no-print-directory tab-tools && $(MAKE) --no-print-directory tab && exec $(TAB_SERVE) "$$@"; \
	else $(PROGRAM) preview $(call quoted,$(PREVIEW_SCENE)) $(PREVIEW_FLAGS) "$$@" $(STAGE_FLAGS) $(FLAGS); fi

## snapshot  the same as a picture, build/preview.png: [FLAGS="--view paths"]
snapshot: all meshes code-built
	@$(PROGRAM) preview $(call quoted,$(PREVIEW_SCENE)) --code '$(CODE_BUILD)' --snapshot '$(PREVIEW_SNAPSHOT)' $(STAGE_FLAGS) $(FLAGS) && echo '$(PREVIEW_SNAPSHOT)'
