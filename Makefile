# photonlab. `make help` lists what there is.
#
# One tree of objects per BUILD directory, so that variants (sanitizers, another compiler, native code) stand side by side:
#     make BUILD=build/clang CC=clang

ifneq ($(filter 3.%,$(MAKE_VERSION)),)
$(error this is make $(MAKE_VERSION), and photonlab needs 4 or later; on a Mac: brew install make, then gmake)
endif

ifeq ($(MAKELEVEL),0)
MAKEFLAGS += -j$(shell getconf _NPROCESSORS_ONLN 2>/dev/null || echo 2)
endif

# Whatever the person's language, numbers have a point and capitals are those of English. Letters beyond ASCII stay letters.
override export LC_ALL := $(or $(firstword $(filter C.UTF-8 C.utf8,$(shell locale -a 2>/dev/null))),C)

# On a machine that has no compiler yet, what the rest of this file finds out would be found out too early: after `setup` a
# second make looks again. What else is asked for says what has to be installed.
ifneq ($(filter setup,$(MAKECMDGOALS)),)

.NOTPARALLEL:
.PHONY: $(MAKECMDGOALS)
setup:
	@sh tests/setup.sh $(filter-out setup,$(MAKECMDGOALS))
	@$(MAKE) --no-print-directory compile_commands.json
$(filter-out setup,$(MAKECMDGOALS)): setup
	@$(MAKE) --no-print-directory $@

else

BUILD  ?= build
CC     := $(if $(filter default,$(origin CC)),$(firstword $(foreach c,gcc clang cc,$(shell command -v $(c) 2>/dev/null)) cc),$(CC))
SYSTEM := $(shell uname -s)

# Same bytes from every compiler: no fused multiply-add, no fast-math. errno of sqrtf is not wanted.
OPTIMISE ?= -O3
STANDARD  = -std=c99 -D_DEFAULT_SOURCE -D_XOPEN_SOURCE=700 $(OWN_NAMES) -Wall -Wextra -Wpedantic -Wshadow -ffp-contract=off -fno-math-errno $(FLOATS) $(BY_CLANG)
# Floats are computed as floats: gcc would take doubles on s390x, and an old coprocessor on i386.
FLOATS := $(shell for by in "" -fexcess-precision=fast "-msse2 -mfpmath=sse"; do \
              [ "`echo __FLT_EVAL_METHOD__ | $(CC) -std=c99 $$by -E -P -x c - 2>/dev/null`" != 0 ] || { echo "$$by"; break; }; done)
# Newer C libraries' strstr and its like are C11's _Generic where GNU's names are asked for; clang tells of it, though it is not ours.
BY_CLANG := $(if $(findstring clang,$(shell $(CC) --version 2>/dev/null)),-Wno-c11-extensions)
PACKAGES  = libpng yaml-0.1
PKG      := $(shell command -v pkg-config 2>/dev/null)
PKG_CFLAGS := $(if $(PKG),$(shell pkg-config --cflags $(PACKAGES) 2>/dev/null))
PKG_LIBS   := $(or $(if $(PKG),$(shell pkg-config --libs $(PACKAGES) 2>/dev/null)),-lpng -lyaml)

# Pictures in EXR, where a program links with OpenEXR's C interface.
EXR_CFLAGS := $(if $(PKG),$(patsubst -I%,-isystem %,$(shell pkg-config --cflags-only-I OpenEXR 2>/dev/null)))
EXR_LIBS   := $(if $(PKG),$(filter -L% -lOpenEXRCore%,$(shell pkg-config --libs OpenEXR 2>/dev/null)))
HAVE_EXR   := $(if $(EXR_LIBS),$(shell echo 'int main(void) { return exr_finish == 0; }' | \
                  $(CC) $(EXR_CFLAGS) -include openexr.h -x c - $(EXR_LIBS) -o /dev/null 2>/dev/null && echo yes))

ifeq ($(SYSTEM),Darwin)
# Apple's compilers do not look where Homebrew puts things, and know OpenMP under another name.
BREW      := $(shell brew --prefix 2>/dev/null)
BREW_AT    = $(BREW) $(addprefix $(BREW)/opt/,$(if $(BREW),libomp libarchive))
OWN_NAMES  = -D_DARWIN_C_SOURCE
OPENMP_BY  = -fopenmp -Xpreprocessor@-fopenmp@-lomp
PKG_CFLAGS += $(BREW_AT:%=-isystem %/include)
PKG_LIBS   += $(BREW_AT:%=-L%/lib)
SHARED     = -dynamiclib -install_name @rpath/libphotonlab.so
PLUGIN     = -dynamiclib -undefined dynamic_lookup
ORIGIN     = @loader_path
else
OPENMP_BY  = -fopenmp
OWN_CALLS  = -fno-semantic-interposition
SHARED     = -shared -Wl,-Bsymbolic-functions
PLUGIN     = -shared
ORIGIN     = $$ORIGIN
endif

# The first way to OpenMP with which a program links, if any; `@` stands for a blank.
OPENMP_WAY := $(firstword $(foreach by,$(OPENMP_BY),$(shell echo 'int main(void) { return omp_in_parallel(); }' | \
                  $(CC) $(subst @, ,$(by)) -include omp.h $(PKG_CFLAGS) -x c - $(filter -L%,$(PKG_LIBS)) -o /dev/null 2>/dev/null && echo $(by))))
OPENMP     := $(filter-out -l%,$(subst @, ,$(OPENMP_WAY)))

override CFLAGS += $(STANDARD) $(OPTIMISE) -g -fPIC $(OWN_CALLS) $(OPENMP) -Ilib -Itests $(PKG_CFLAGS) $(or $(EXTRA),$(if $(CHECK),-Werror))
LDLIBS           = $(PKG_LIBS) -lm $(if $(filter Linux,$(SYSTEM)),-ldl) $(subst @, ,$(OPENMP_WAY))

# Folders called test hold programs of their own.
find_c           = $(sort $(shell find $(1) -name '*.c' ! -path '*/test/*' 2>/dev/null))
LIBRARY_SOURCES := $(filter-out lib/cli/% lib/preview/% lib/image/exr$(if $(HAVE_EXR),_none).c,$(call find_c,lib))
# Without the headers of GLFW and OpenGL there is no preview, and `photonlab preview` says what to install.
HAVE_PREVIEW    := $(shell $(CC) $(PKG_CFLAGS) -DGLFW_INCLUDE_GLCOREARB -include GLFW/glfw3.h -fsyntax-only -x c /dev/null 2>/dev/null && echo yes)
PREVIEW_SOURCES := $(if $(HAVE_PREVIEW),$(call find_c,lib/preview))
PROGRAM_SOURCES := $(filter-out $(if $(HAVE_PREVIEW),%/preview_none.c,%/preview.c %/frame.c),$(call find_c,lib/cli)) $(PREVIEW_SOURCES)
STEP_SOURCES     = $(wildcard solutions/*/*.c)

object   = $(patsubst %.c,$(BUILD)/obj/%.o,$(1))
LIBRARY  = $(BUILD)/libphotonlab.so
PROGRAM  = $(BUILD)/photonlab
STEPS    = $(STEP_SOURCES:%.c=$(BUILD)/%.so)
-include prebuilt/steps.mk
# Where the checkout cannot be written, the scenes without a mesh can be rendered.
MESHES   = $(if $(shell test -w scenes/meshes && echo yes),$(addprefix scenes/meshes/,diamond.obj bumpy_sphere.obj ring.obj))

# For a shell: one word, whatever it holds.
quoted = '$(subst ','\'',$(1))'

# `make V=1` shows whole commands.
Q   = $(if $(V),,@)
say = @$(if $(V),:,echo "  $(1) $(2)")

# A line with a make of its own runs under `make -n`, too; where it does more than make, it ends there at once.
ONLY_SHOWN = $(if $(findstring n,$(firstword -$(MAKEFLAGS))),exit;)

.PHONY: all
all: $(PROGRAM) $(STEPS)

# $(call beside,COMMAND): a command that writes $$new, which then takes the target's place: what is half made is no target, what
# runs keeps the old file, and two makes at once do not meet.
beside = $(Q)mkdir -p $(@D) && new=$@.new$$$$ && { { $(1); } && mv $$new $@ || { rm -f $$new; exit 1; }; }
.DELETE_ON_ERROR:

$(BUILD)/obj/%.o: %.c
	$(call say,cc,$<)
	$(call beside,$(CC) $(CFLAGS) -MMD -MP -MT $@ -MF $(@:.o=.d) -c $< -o $$new)

$(BUILD)/obj/lib/image/exr.o: override CFLAGS += $(EXR_CFLAGS)
$(LIBRARY): LDLIBS += $(if $(HAVE_EXR),$(EXR_LIBS))
$(LIBRARY): $(call object,$(LIBRARY_SOURCES))
	$(call say,link,$@)
	$(call beside,$(CC) $(CFLAGS) $(SHARED) $^ -o $$new $(LDLIBS))

# $(call link,LIBRARIES): a program of its objects and the library, which lies beside it or up to two folders above.
define link
$(call say,link,$@)
$(call beside,$(CC) $(CFLAGS) $(filter %.o,$^) -L$(BUILD) -lphotonlab $(foreach up,. .. ../..,-Wl,-rpath,'$(ORIGIN)/$(up)') -o $$new $(1) $(LDLIBS))
endef

$(PROGRAM): $(call object,$(PROGRAM_SOURCES)) $(LIBRARY)
	$(call link)

# One shared object per step.
$(BUILD)/solutions/%.so: $(BUILD)/obj/solutions/%.o
	$(call beside,$(CC) $(CFLAGS) $(PLUGIN) $< -o $$new)

$(BUILD)/make_meshes: scenes/make_meshes.c scenes/mesh_shapes.h
	$(call beside,$(CC) $(STANDARD) -O2 $< -o $$new -lm)

scenes/meshes/%.obj: scenes/make_meshes.c scenes/mesh_shapes.h | $(BUILD)/make_meshes
	$(call beside,$(BUILD)/make_meshes $(subst bumpy_,,$*) $$new)

# `make check` sanitizes neither the preview nor its tests: they start compilers and draw by software, for long.
SANITIZED = $(MAKE) BUILD=$(BUILD)/sanitized$(if $(CHECK),/few HAVE_PREVIEW=) OPTIMISE=-O1 EXTRA="-g1 -fsanitize=address,undefined -fno-sanitize-recover=undefined"

include lib/preview/preview.mk web/web.mk tests/judge/judge.mk tests/steps/exercises.mk web/serve/serve.mk
-include course_notes/notes.mk tests/class/class.mk tests/tests.mk

# ---- what there is to do ----
#
# A line of two hashes tells of a target: "## NAME  words" to students, "##teacher NAME  words", "##maintainer NAME  words". And
# "##check WHEN NAME  words" makes it a part of `make check`, WHEN being when tests/check.sh runs it; `long`: never.

.PHONY: help demo render render-parallel render-slurm meshes check compile_commands.json clean
HELP = $(addprefix help-,teacher maintainer checks)
.PHONY: $(HELP)
help $(HELP):
	@awk -v group=$(patsubst help-%,%,$(filter-out help,$@)) -f tests/help.awk $(filter-out Makefile %.d,$(MAKEFILE_LIST)) Makefile

## render  a picture: make render SCENE=scenes/prism.yaml [CODE=exercises] [FLAGS="--samples 64"]
SCENE ?= scenes/box_glass.yaml
CODE_ASKED = $(filter-out undefined file,$(origin CODE))
render: all meshes $(if $(CODE_ASKED),code-built)
	$(PROGRAM) render $(call quoted,$(SCENE)) -o $(call quoted,$(BUILD)/$(notdir $(SCENE:.yaml=.png))) $(if $(CODE_ASKED),--code $(CODE_BUILD)) $(FLAGS)

##maintainer render-parallel  a picture by passes on many machines: SSH=anna,bert,: [SCENE=…] [PASSES=64] [PARTS=8] [FLAGS=…]; scenes/machines/
##maintainer render-slurm  the same by a Slurm cluster
PASSES ?= 64
PARTS  ?= 8
SSH    ?= :
MANY    = $(PROGRAM) $(call quoted,$(SCENE)) $(call quoted,$(BUILD)/$(notdir $(SCENE:.yaml=.png))) $(PASSES) $(PARTS)
render-parallel: all meshes
	@bash scenes/machines/parallel.sh $(MANY) $(call quoted,$(SSH)) $(FLAGS)
render-slurm: all meshes
	@bash scenes/machines/slurm.sh $(MANY) $(FLAGS)

## demo  the course's pictures, rendered into build/demo/
demo: all meshes
	@sh scenes/demo.sh $(PROGRAM) $(BUILD)/demo

## (no target)  build the program, build/photonlab, and the reference: build/solutions/
## setup  install what is missing (by apt; on other systems it says what to install)

## meshes  make the meshes that are too large to keep: scenes/meshes/
meshes: $(MESHES)

##maintainer check  all tests but the long ones above (five minutes); make help-checks lists them
check:
	@$(ONLY_SHOWN) bash tests/check.sh $(MAKE) $(filter-out %.d,$(MAKEFILE_LIST))

## compile_commands.json  for editors; `make setup` makes it, too
compile_commands.json:
	@{ find lib solutions tests/judge tests/steps tests/unit tests/class -name '*.c' | \
	       sed 's|.*|{"directory": "$(CURDIR)", "file": "&", "command": "$(CC) $(CFLAGS) -c &"},|'; \
	   find exercises -name '[0-9]*.c' ! -path '*/.*' | \
	       sed 's|.*|{"directory": "$(CURDIR)", "file": "&", "command": "$(CC) $(STEP_FLAGS) -Ilib -c &"},|'; } 2>/dev/null | \
	   sed '1s/^/[/; $$s/,$$/]/' >$@.new
	@mv $@.new $@

## clean  remove build/
clean:
	rm -rf $(BUILD)

.SECONDARY:
-include $(shell find $(BUILD)/obj -name '*.d' 2>/dev/null)

endif
