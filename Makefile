# photonlab. `make help` lists what there is.
#
# One tree of objects per BUILD directory, so that variants (sanitizers, another compiler, native code) stand side by side:
#     make BUILD=build/clang CC=clang

ifeq ($(MAKELEVEL),0)
MAKEFLAGS += -j$(shell getconf _NPROCESSORS_ONLN 2>/dev/null || echo 2)
endif

# On a machine that has no compiler yet, what the rest of this file finds out would be found out too early: after `setup` a
# second make looks again.
ifneq ($(filter setup,$(MAKECMDGOALS)),)

.NOTPARALLEL:
.PHONY: $(MAKECMDGOALS)
setup:
	@sh tests/setup.sh
$(filter-out setup,$(MAKECMDGOALS)): setup
	@$(MAKE) --no-print-directory $@

else

BUILD  ?= build
CC     := $(if $(filter default,$(origin CC)),$(firstword $(foreach c,gcc clang cc,$(shell command -v $(c) 2>/dev/null)) cc),$(CC))
SYSTEM := $(shell uname -s)

# Same bytes from every compiler: no fused multiply-add, no fast-math. errno of sqrtf is not wanted.
OPTIMISE ?= -O3
STANDARD  = -std=c99 -D_DEFAULT_SOURCE -D_XOPEN_SOURCE=700 -Wall -Wextra -Wpedantic -Wshadow -ffp-contract=off -fno-math-errno
OPENMP   := $(shell echo 'int main(void){return 0;}' | $(CC) -fopenmp -x c - -o /dev/null 2>/dev/null && echo -fopenmp)
PACKAGES  = libpng yaml-0.1
PKG      := $(shell command -v pkg-config 2>/dev/null)
PKG_CFLAGS := $(if $(PKG),$(shell pkg-config --cflags $(PACKAGES) 2>/dev/null))
PKG_LIBS   := $(or $(if $(PKG),$(shell pkg-config --libs $(PACKAGES) 2>/dev/null)),-lpng -lyaml)

override CFLAGS += $(if $(HAVE_PREVIEW),,-DWITHOUT_PREVIEW) $(STANDARD) $(OPTIMISE) -g -fPIC -fno-semantic-interposition $(OPENMP) -Ilib -Itests $(PKG_CFLAGS) $(EXTRA)
LDLIBS           = $(PKG_LIBS) -lm $(if $(filter Linux,$(SYSTEM)),-ldl) $(OPENMP)

ifeq ($(SYSTEM),Darwin)
SHARED = -dynamiclib -install_name @rpath/libphotonlab.so
PLUGIN = -bundle -undefined dynamic_lookup
ORIGIN = @loader_path
else
SHARED = -shared -Wl,-Bsymbolic-functions
PLUGIN = -shared
ORIGIN = $$ORIGIN
endif

find_c           = $(sort $(shell find $(1) -name '*.c' 2>/dev/null))
LIBRARY_SOURCES := $(filter-out lib/cli/% lib/preview/%,$(call find_c,lib))
# Without the headers of GLFW and OpenGL there is no preview, and `photonlab preview` says what to install.
HAVE_PREVIEW    := $(shell $(CC) -DGLFW_INCLUDE_GLCOREARB -include GLFW/glfw3.h -fsyntax-only -x c /dev/null 2>/dev/null && echo yes)
PROGRAM_SOURCES := $(filter-out $(if $(HAVE_PREVIEW),,lib/preview/% lib/cli/preview_%),$(call find_c,lib/cli lib/preview))
STEP_SOURCES    = $(wildcard solutions/*/*.c)
TEST_SOURCES    = $(filter-out $(SKIP) $(if $(HAVE_PREVIEW),,tests/unit/preview/%),$(wildcard tests/unit/*/*.c))

object   = $(patsubst %.c,$(BUILD)/obj/%.o,$(1))
LIBRARY  = $(BUILD)/libphotonlab.so
PROGRAM  = $(BUILD)/photonlab
STEPS    = $(STEP_SOURCES:%.c=$(BUILD)/%.so)
-include prebuilt/steps.mk
TESTS    = $(TEST_SOURCES:tests/unit/%.c=$(BUILD)/tests/%)
MESHES   = $(addprefix scenes/meshes/,diamond.obj bumpy_sphere.obj ring.obj)

# `make V=1` shows whole commands.
Q   = $(if $(V),,@)
say = @$(if $(V),:,echo "  $(1) $(2)")

.PHONY: all
all: $(PROGRAM) $(STEPS)

$(BUILD)/obj/%.o: %.c
	@mkdir -p $(@D)
	$(call say,cc,$<)
	$(Q)$(CC) $(CFLAGS) -MMD -MP -c $< -o $@

$(LIBRARY): $(call object,$(LIBRARY_SOURCES))
	$(call say,link,$@)
	$(Q)$(CC) $(CFLAGS) $(SHARED) $^ -o $@.new $(LDLIBS)
	@mv $@.new $@

$(PROGRAM): $(call object,$(PROGRAM_SOURCES)) $(LIBRARY)
	$(call say,link,$@)
	$(Q)$(CC) $(CFLAGS) $(filter %.o,$^) -L$(BUILD) -lphotonlab -Wl,-rpath,'$(ORIGIN)' -o $@.new $(LDLIBS)
	@mv $@.new $@

# One shared object per step. Written beside and renamed, since a running program may be loading the old one.
$(BUILD)/solutions/%.so: $(BUILD)/obj/solutions/%.o
	@mkdir -p $(@D)
	$(Q)$(CC) $(CFLAGS) $(PLUGIN) $< -o $@.new
	@mv $@.new $@

$(BUILD)/tests/%: $(BUILD)/obj/tests/unit/%.o $(LIBRARY)
	@mkdir -p $(@D)
	$(Q)$(CC) $(CFLAGS) $< -L$(BUILD) -lphotonlab -lcmocka -Wl,-rpath,'$(ORIGIN)/../..' -o $@ $(LDLIBS)

$(BUILD)/make_meshes: scenes/make_meshes.c
	@mkdir -p $(@D)
	$(Q)$(CC) $(STANDARD) -O2 $< -o $@ -lm

scenes/meshes/%.obj: scenes/make_meshes.c | $(BUILD)/make_meshes
	@mkdir -p $(@D)
	$(Q)$(BUILD)/make_meshes $(subst bumpy_,,$*) $@

include tests/steps/exercises.mk tests/judge/judge.mk lib/preview/preview.mk
-include tests/scene_page/scene_page.mk tests/class/class.mk tests/mistakes/grader.mk course_notes/notes.mk

# ---- what there is to do; `make help` prints the lines with two hashes ----

.PHONY: help demo render meshes check check-unit check-sanitized check-compilers check-bytes check-cli check-cli-sanitized check-probe check-arm reference agreement \
        bench fuzz format clean

## help            this list
help:
	@echo "make TARGET [NAME=value …]"
	@sed -n 's/^## /  /p' $(filter-out %.d,$(MAKEFILE_LIST))

## (no target)     build the program: build/photonlab, and the reference steps: build/solutions/

## setup           install what is missing (by apt; on other systems it says what to install)

## demo            render the course's pictures into build/demo/
demo: all meshes
	@sh scenes/demo.sh $(PROGRAM) $(BUILD)/demo

## render          render one scene: make render SCENE=scenes/prism.yaml FLAGS="--samples 64" [CODE=exercises: with your steps]
SCENE ?= scenes/box_glass.yaml
CODE_ASKED = $(filter-out undefined file,$(origin CODE))
render: all meshes $(if $(CODE_ASKED),code-built)
	$(PROGRAM) render $(SCENE) -o $(BUILD)/$(notdir $(SCENE:.yaml=.png)) $(if $(CODE_ASKED),--code $(CODE_BUILD)) $(FLAGS)

## meshes          make the meshes that are too large to keep: scenes/meshes/
meshes: $(MESHES)

## check           all tests (below five minutes on two cores); the parts are:
check: all meshes
	@bash tests/check.sh $(MAKE)

##   check-unit        the library's unit tests
check-unit: all meshes $(TESTS)
	@bash tests/unit/run.sh $(TESTS)

##   check-sanitized   the same under AddressSanitizer and UndefinedBehaviorSanitizer (`make check` leaves the preview's out)
check-sanitized: meshes
	@$(SANITIZED) check-unit
SANITIZED = $(MAKE) BUILD=$(BUILD)/sanitized OPTIMISE=-O1 \
            EXTRA="-fsanitize=address,undefined -fno-sanitize-recover=undefined"
check-cli-sanitized: meshes
	@$(SANITIZED) check-cli

##   check-compilers   gcc and clang build without a warning, tests and fuzz targets too
# What gcc has built already it need not build again; `make check` has it build with -Werror from the start.
GCC_BUILD = $(if $(filter gcc,$(CC)),$(BUILD),$(BUILD)/gcc)
check-compilers:
	@$(MAKE) BUILD=$(GCC_BUILD) CC=gcc EXTRA=-Werror all $(TEST_SOURCES:tests/unit/%.c=$(GCC_BUILD)/tests/%)
	@$(MAKE) BUILD=$(BUILD)/clang CC=clang EXTRA=-Werror all
	$(Q)printf '%s\n' $(TEST_SOURCES) $(call find_c,tests/fuzz tests/judge tests/steps tests/class) | \
	    xargs -n 8 -P $(shell getconf _NPROCESSORS_ONLN) clang $(STANDARD) $(OPENMP) -Werror -fsyntax-only -Ilib -Itests $(PKG_CFLAGS)
	$(Q)gcc $(STANDARD) $(OPENMP) -Werror -fsyntax-only -Ilib -Itests $(PKG_CFLAGS) $(wildcard tests/fuzz/*.c)

##   check-bytes       1, 2 and 7 threads, gcc and clang: the same bytes
check-bytes: check-compilers meshes
	@bash tests/same_bytes.sh $(GCC_BUILD)/photonlab $(BUILD)/clang/photonlab

##   check-cli         exit codes, messages, students' steps; check-cli-sanitized: the same under sanitizers
check-cli: all
	@bash tests/cli.sh $(PROGRAM) $(BUILD)

##   check-probe       what the judge asks of a step, in numbers
check-probe: all $(PROBE)
	@bash tests/probe.sh $(PROGRAM) $(BUILD)

##   check-rooms       which folder includes which: as lib/README.md and tests/README.md say?
.PHONY: check-rooms size
check-rooms:
	@bash tests/rooms_test.sh

## size            lines of C and shell, room by room: make size [OF=COMMIT]
size:
	@sh tests/size.sh $(OF)

##   check-arm         the unit tests built for aarch64 and emulated, and one picture against this machine's to the byte (on
##                     Debian: gcc-aarch64-linux-gnu, qemu-user, and the libraries of `make setup` with :arm64)
ARM = BUILD=$(BUILD)/arm CC=aarch64-linux-gnu-gcc PKG_CFLAGS= PKG_LIBS="-lpng -lyaml"
PICTURE = render scenes/box_glass.yaml --size 97x61 --photons 60000 --samples 3 --quiet
check-arm: all meshes
	@RUNNER="qemu-aarch64 -L /" $(MAKE) $(ARM) check-unit
	@qemu-aarch64 -L / $(BUILD)/arm/photonlab $(PICTURE) -o $(BUILD)/arm/there.pfm
	@$(PROGRAM) $(PICTURE) -o $(BUILD)/arm/here.pfm
	@cmp $(BUILD)/arm/there.pfm $(BUILD)/arm/here.pfm && echo "the same picture to the byte"

##   check-same        another commit's pictures, photons and measurements, and this one's: the same bytes? make check-same AS=COMMIT
.PHONY: check-same
check-same: judge meshes
	@bash tests/same_as.sh "$${AS:?says which commit}" $(BUILD)

##   reference         both integrators against an independent renderer's images
reference: all
	@bash tests/reference/compare.sh $(PROGRAM)

##   agreement         photons against the path tracer, on every scene that it can render (SCENES=few: half of them, as `make check` does)
agreement: all meshes
	@bash tests/agreement.sh $(PROGRAM) $(SCENES)

BENCH_OBJECTS = $(call object,tests/bench/photons.c lib/cli/common.c)
$(BUILD)/bench_photons: $(BENCH_OBJECTS) $(LIBRARY)
	$(call say,link,$@)
	$(Q)$(CC) $(CFLAGS) $(BENCH_OBJECTS) -L$(BUILD) -lphotonlab -Wl,-rpath,'$(ORIGIN)' -o $@ $(LDLIBS)

## bench           speed against other programs, as ratios measured side by side (installs them first)
bench: all meshes
	@bash tests/bench/run.sh

## fuzz            feed a reader with nonsense: make fuzz READER=scene|obj|png|pfm SECONDS=600 (needs clang)
READER  ?= scene
SECONDS ?= 60
SEEDS = $(wildcard $(addsuffix *.$(READER:scene=yaml),tests/malformed/ scenes/))
FUZZ_FLAGS = -fsanitize=fuzzer,address,undefined -fno-sanitize-recover=undefined
fuzz: $(SCENE_PAGE)
	@test -f tests/fuzz/fuzz_$(READER).c || { echo "READER is scene, obj, png or pfm"; exit 1; }
	@mkdir -p $(BUILD)/fuzz/corpus_$(READER)
	clang $(STANDARD) -O1 -g -Ilib $(PKG_CFLAGS) $(FUZZ_FLAGS) tests/fuzz/fuzz_$(READER).c $(LIBRARY_SOURCES) \
	    -o $(BUILD)/fuzz/fuzz_$(READER) $(PKG_LIBS) -lm -ldl || \
	    { echo "Does clang lack its fuzzer? On Debian: apt-get install libclang-rt-$$(clang -dumpversion | cut -d. -f1)-dev"; exit 1; }
	$(if $(SEEDS),@cp $(SEEDS) $(BUILD)/fuzz/corpus_$(READER))
	@cp tests/fuzz/*.dict $(BUILD)/fuzz/ && $(SCENE_PAGE) --words >>$(BUILD)/fuzz/scene.dict
	$(BUILD)/fuzz/fuzz_$(READER) -max_total_time=$(SECONDS) -timeout=10 -max_len=4096 -print_final_stats=1 \
	    $(if $(filter scene obj,$(READER)),-dict=$(BUILD)/fuzz/$(READER).dict) $(BUILD)/fuzz/corpus_$(READER)

## compile_commands.json   for editors and language servers
compile_commands.json: Makefile $(LIBRARY_SOURCES) $(PROGRAM_SOURCES) $(STEP_SOURCES) $(TEST_SOURCES)
	@{ echo "["; first=1; for f in $(LIBRARY_SOURCES) $(PROGRAM_SOURCES) $(STEP_SOURCES) $(TEST_SOURCES); do \
	    [ -n "$$first" ] || echo ","; first=; \
	    printf '{"directory":"%s","file":"%s","command":"%s"}' "$(CURDIR)" "$$f" "$(CC) $(CFLAGS) -c $$f"; \
	done; echo; echo "]"; } > $@.new
	@mv $@.new $@

## format          lay the C files out by .clang-format
format:
	clang-format -i $$(git ls-files '*.c' '*.h' '*.cpp')

## clean           remove build/
clean:
	rm -rf $(BUILD)

.SECONDARY:
-include $(shell find $(BUILD)/obj -name '*.d' 2>/dev/null)

endif
