# The live preview; included by the Makefile. lib/preview/ belongs to the program, not to the library: steps never draw.

PREVIEW_SOURCES := $(call find_c,lib/preview)
PREVIEW_TESTS   = $(wildcard tests/unit/preview/*.c)

$(PREVIEW_TESTS:tests/unit/%.c=$(BUILD)/tests/%): $(BUILD)/tests/%: $(BUILD)/obj/tests/unit/%.o $(call object,$(PREVIEW_SOURCES)) $(LIBRARY)
	@mkdir -p $(@D)
	$(Q)$(CC) $(CFLAGS) $(filter %.o,$^) -L$(BUILD) -lphotonlab -lcmocka -Wl,-rpath,'$(ORIGIN)/../..' -o $@ $(LDLIBS)

# STAGE chooses the scene, where SCENE does not: one in which all of its steps play, mirror and glass of stage 1 too.
STAGE_SCENES    := $(shell sed -n 's/^STAGE.\([0-9]*\), *"\(.*\)".*/\1=\2/p' lib/steps/steps.def)
PREVIEW_SCENE    = $(if $(filter undefined file,$(origin SCENE)),$(or $(patsubst $(or $(STAGE),1)=%,%,$(filter $(or $(STAGE),1)=%,$(STAGE_SCENES))),$(error STAGE=$(STAGE): expected one of $(foreach s,$(STAGE_SCENES),$(firstword $(subst =, ,$(s)))))),$(SCENE))
PREVIEW_SNAPSHOT = $(BUILD)/preview.png

# How one saved file becomes one object: what `make` itself does, without asking make. Two previews may build the same one.
PREVIEW_BUILD = mkdir -p "$${2%/*}" && $(CC) $(CFLAGS) $(PLUGIN) -MMD -MP -MT "$$2" -MF "$${2%.so}.d" "$$1" -o "$$2.new$$$$" && mv "$$2.new$$$$" "$$2"
PREVIEW_FLAGS = --code '$(CODE_BUILD)' --watch '$(CODE_SOURCE)' --build '$(subst ','\'',$(PREVIEW_BUILD))' --report '$(BUILD)/report/index.html'

.PHONY: preview snapshot check-preview bench-preview

## preview         the photons of your code in a window, new after every save: make preview [STAGE=3] [SCENE=scenes/prism.yaml]
preview: all meshes code-built
	@$(PROGRAM) preview '$(PREVIEW_SCENE)' $(PREVIEW_FLAGS) $(FLAGS)

## snapshot        the same as a picture, without a display: build/preview.png; more in FLAGS="--view paths"
snapshot: all meshes code-built
	@$(PROGRAM) preview '$(PREVIEW_SCENE)' --code '$(CODE_BUILD)' --snapshot '$(PREVIEW_SNAPSHOT)' $(FLAGS) && echo '$(PREVIEW_SNAPSHOT)'

##   check-preview     the window under Xvfb: faults in students' code, every key, the same bytes from OSMesa, EGL and GLFW
check-preview: all meshes
	@bash tests/preview/check.sh $(PROGRAM) $(BUILD) '$(subst ','\'',$(PREVIEW_BUILD))'

## bench-preview   how soon after a save the photons are there, frames a second, idle processor time; with software OpenGL
bench-preview: all meshes
	@bash tests/bench/preview.sh $(PROGRAM) $(BUILD) '$(subst ','\'',$(PREVIEW_BUILD))'
