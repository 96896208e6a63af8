# The course in a browser: the library as a WebAssembly module, and pages around it. Included by the Makefile.

WASM_CC  ?= clang
WASM      = $(BUILD)/web
# As native code is compiled, with the same roundings; without OpenMP, whose pragmas alone name some parameters. Headers that are no part of WASI's C library (OpenGL, stb, libyaml) are
# looked for where the system has them, and last.
PROGRAM_LIBC := $(subst .,,$(filter 2.%,$(shell getconf GNU_LIBC_VERSION 2>/dev/null)))
WASM_FLAGS = --target=wasm32-wasi $(STANDARD) -DPROGRAM_LIBC=$(or $(PROGRAM_LIBC),236) -Wno-unused-parameter -O3 -msimd128 -fno-stack-protector -Ilib -I. -idirafter /usr/include
WASM_LINK  = -mexec-model=reactor -Wl,--strip-all -Wl,--stack-first -Wl,-z,stack-size=1048576 -Wl,--export=free

# What needs a system below it stays out: processes, signals, loading of objects, windows.
WASM_WITHOUT = lib/base/crash_% lib/base/process.c lib/base/file_disk.c lib/image/png.c lib/image/exr.c lib/render/passes/pass_file.c lib/steps/steps_load.c lib/preview/draw/context/%
WASM_SOURCES = $(filter-out $(WASM_WITHOUT),$(LIBRARY_SOURCES) $(call find_c,lib/preview/draw lib/preview/record lib/preview/view) \
               $(addprefix lib/preview/run/worker_,work.c render.c) \
               $(STEP_SOURCES) $(wildcard web/module/*.c web/figures/*.c))
LIBYAML_PARTS = api reader scanner parser

.PHONY: wasm site check-wasm

##maintainer wasm  the library, the solutions and the preview's drawing as a module for browsers: build/web/photonlab.wasm
wasm: $(WASM)/photonlab.wasm

$(WASM)/photonlab.wasm: $(WASM_SOURCES:%.c=$(WASM)/%.o) $(LIBYAML_PARTS:%=$(WASM)/libyaml/%.o)
	$(call say,link,$@)
	$(call beside,$(WASM_CC) --target=wasm32-wasi -O3 $(WASM_LINK) $^ -o $$new)

$(WASM)/libyaml/%.o: $(WASM)/libyaml/source
	$(call beside,$(WASM_CC) --target=wasm32-wasi -O2 -idirafter /usr/include -DYAML_VERSION_MAJOR=0 -DYAML_VERSION_MINOR=2 \
	    -DYAML_VERSION_PATCH=5 -DYAML_VERSION_STRING='"0.2.5"' -c $(@:.o=.c) -o $$new)

$(WASM)/libyaml/source: web/module/libyaml.sh
	$(Q)mkdir -p $(@D) && sh web/module/libyaml.sh $(abspath $(@D)) && touch $@

$(WASM)/%.o: %.c | wasm-tools
	$(call say,wasm,$<)
	$(call beside,$(WASM_CC) $(WASM_FLAGS) $(or $(EXTRA),$(if $(CHECK),-Werror)) -MMD -MP -MT $@ -MF $(@:.o=.d) -c $< -o $$new)

.PHONY: wasm-tools
wasm-tools:
	@[ -n "$(STEP_SOURCES)" ] || { echo "The module is made with the solutions, whose sources are not here." >&2; exit 1; }
	@echo 'int main(void){return 0;}' | $(WASM_CC) --target=wasm32-wasi -include stdlib.h -x c - -o /dev/null 2>/dev/null || \
	    { echo "A compiler for WebAssembly is missing. On Debian: sudo apt-get install clang lld wasi-libc libclang-rt-dev-wasm32" >&2; exit 1; }

-include $(shell find $(WASM) -name '*.d' 2>/dev/null)

# A scene whose mesh would fill the page stays out.
SITE_SCENES = $(filter-out scenes/bumpy_glass.yaml,$(wildcard scenes/*.yaml))

$(BUILD)/site/lab.html: web/page/make_page.sh $(wildcard web/lab/* web/page/*.js) $(WASM)/photonlab.wasm $(SITE_SCENES) $(MESHES)
	$(call say,page,$@)
	$(call beside,sh web/page/make_page.sh web/lab/lab.html $(WASM)/photonlab.wasm $(SITE_SCENES) >$$new)

##teacher site  notes and lab as pages for your students, for a web host or a disk: build/site/
site: $(BUILD)/site/lab.html
	+@$(MAKE) --no-print-directory notes-pages NOTES=$(BUILD)/site NOTES_MODULE=$(WASM)/photonlab.wasm NOTES_WITHOUT=teachers
	@echo "$(BUILD)/site/index.html, $(BUILD)/site/lab.html"

##check long check-wasm  the module's photons are the program's, to the byte
check-wasm: all meshes $(WASM)/photonlab.wasm
	@node tests/web/same_photons.mjs $(PROGRAM) $(WASM)/photonlab.wasm

.PHONY: check-lab check-site bench-site
# Firefox draws on a display only.
SITE_TOOLS = $(WASM)/node_modules/puppeteer-core
$(SITE_TOOLS):
	$(Q)npm install --silent --no-fund --no-audit --prefix $(WASM) puppeteer-core
ON_DISPLAY = $(if $(shell command -v xvfb-run 2>/dev/null),xvfb-run -a -s '-screen 0 1600x1200x24')

##check beside check-lab  the lab and a live figure in a browser, where there is one and check-site has run: seconds
check-lab: $(if $(wildcard $(SITE_TOOLS)),all meshes $(BUILD)/site/lab.html)
	@if [ -d $(SITE_TOOLS) ]; then $(ON_DISPLAY) node tests/web/check_short.mjs $(PROGRAM) $(BUILD)/site/lab.html $(WASM)/photonlab.wasm $(WASM); \
	else printf '○ no puppeteer-core here, which make check-site fetches: the lab was not opened\n0 passed, 0 failed\n'; fi

##check long check-site  lab and live figures in Chromium and Firefox, what of them is there: by mouse, keys and touch (ten minutes); screenshots in build/web/shots/
check-site: all meshes site | $(SITE_TOOLS)
	@$(ON_DISPLAY) node tests/web/check_lab.mjs $(PROGRAM) $(BUILD)/site $(WASM) $(WASM)/shots
	@$(ON_DISPLAY) node tests/web/check_figures.mjs $(BUILD)/site $(WASM) $(WASM)/shots

##maintainer bench-site  photon paths a second in the page against the program on one thread; frames a second while the scene is turned
bench-site: all meshes $(BUILD)/site/lab.html | $(SITE_TOOLS)
	@$(ON_DISPLAY) node tests/web/bench_lab.mjs $(PROGRAM) $(BUILD)/site $(WASM)
