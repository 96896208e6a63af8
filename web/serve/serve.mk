# A student's own code in a tab of the browser; included by web.mk.
#
# The library's part of the module is compiled once, to one object, and comes with the students' archive in prebuilt/wasm/, as do the
# reference's steps. A save compiles one step and links: an archive gives only what is missing.

TAB           = $(WASM)/tab
TAB_CODE      = $(TAB)/code/$(or $(CODE_KEY),exercises)
SERVE         = $(BUILD)/serve
PREBUILT_WASM = $(if $(STEP_SOURCES),,$(wildcard prebuilt/wasm/library.o))
TAB_LIBRARY   = $(if $(PREBUILT_WASM),prebuilt/wasm,$(TAB))/library.o
TAB_REFERENCE = $(TAB_LIBRARY:library.o=reference.a)
TAB_SCENES    = $(SITE_SCENES) $(filter-out $(SITE_SCENES),$(PREVIEW_SCENE))

$(TAB)/library.o: $(patsubst %.c,$(WASM)/%.o,$(filter-out $(STEP_SOURCES) web/figures/%,$(WASM_SOURCES))) $(LIBYAML_PARTS:%=$(WASM)/libyaml/%.o)
	$(call say,link,$@)
	$(call beside,wasm-ld -r $^ -o $$new)

$(TAB)/reference.a: $(STEP_SOURCES:%.c=$(WASM)/%.o)
	$(call beside,rm -f $$new; llvm-ar rcs $$new $^)

# For a shell, as STEP_COMPILE: with traps where the window's processes get a segmentation fault, and a guard against loops.
TAB_FLAGS   = $(filter-out -O3,$(WASM_FLAGS)) -O2 -g -fsanitize=null,bounds -fsanitize-minimal-runtime -fsanitize-coverage=edge,no-prune,trace-pc
TAB_COMPILE = mkdir -p "$${2%/*}" && $(WASM_CC) $(TAB_FLAGS) -MMD -MP -MT "$$2" -MF "$${2%.so}.d" -c "$$1" -o "$$2.new$$$$" && mv "$$2.new$$$$" "$$2"
TAB_MODULE  = $(WASM_CC) --target=wasm32-wasi $(filter-out -Wl$(COMMA)--strip-all,$(WASM_LINK)) -Wl,-z,stack-size=8388608
TAB_LINK    = module=$$1; shift; $(TAB_MODULE) -Wl,--export=__stack_pointer,--max-memory=1073741824,--wrap=malloc,--wrap=calloc,--wrap=realloc \
              "$$@" $(TAB_LIBRARY) $(TAB_REFERENCE) -o "$$module.new" && mv "$$module.new" "$$module"
COMMA      := ,

$(TAB)/photonlab.wasm: $(TAB_LIBRARY) $(TAB_REFERENCE)
	$(call beside,$(WASM_CC) --target=wasm32-wasi $(WASM_LINK) $^ -o $$new)

# The lab's page, with its scripts in a file of their own and the panel for one's steps.
TAB_SCRIPTS = web/serve/tab.js $(filter-out web/lab/lab.js,$(shell sed -n 's/^@FILE \(.*\.js\)@/\1/p' web/lab/lab.html)) web/lab/lab.js
$(TAB)/tab.js: $(TAB_SCRIPTS)
	$(call beside,cat $^ >$$new)

$(TAB)/tab.html: web/page/make_page.sh web/lab/lab.html web/lab/lab.css web/serve/tab.css $(TAB_SCENES) $(MESHES)
	$(Q)mkdir -p $(@D); sed -e '/^@MODULE@/d; s|^@FILE web/lab/lab.css@|&\n@FILE web/serve/tab.css@|' \
	    -e '/^<script>/,/^<\/script>/c<script src="tab.js"></script>' web/lab/lab.html >$(TAB)/template.html
	$(call beside,sh web/page/make_page.sh $(TAB)/template.html - $(TAB_SCENES) >$$new)

$(SERVE): $(call object,$(wildcard web/serve/*.c) $(filter lib/preview/watch/% lib/preview/record/%,$(call find_c,lib/preview))) $(LIBRARY)
	$(call link,-lmicrohttpd -ljansson)
$(BUILD)/obj/web/serve/%.o: override CFLAGS += -I.

$(TAB_CODE)/%.so: $(CODE_SOURCE)/%.c
	$(call say,wasm,$<)
	$(Q)set -- '$<' '$@'; $(TAB_COMPILE) || { rm -rf $@ $@.new*; echo "  ✗ $< does not compile; the reference plays in its place"; }
-include $(wildcard $(TAB_CODE)/*/*.d)

.PHONY: tab tab-parts tab-tools
tab-parts: $(TAB_LIBRARY) $(TAB_REFERENCE)
tab-tools:
	@for tool in $(WASM_CC) wasm-ld llvm-ar llvm-symbolizer; do command -v $$tool >/dev/null || missing="$$missing $$tool"; done; \
	echo '#include <microhttpd.h>' | $(CC) -fsyntax-only -x c - 2>/dev/null || missing="$$missing libmicrohttpd"; \
	echo 'int main(void){return 0;}' | $(WASM_CC) --target=wasm32-wasi -include stdlib.h -x c - -o /dev/null 2>/dev/null || missing="$$missing wasi-libc"; \
	[ -z "$$missing" ] || { echo "Your photons in the browser need what is missing here:$$missing. On Debian: make setup WEB=1" >&2; exit 1; }; \
	[ -n "$(PREBUILT_WASM)$(STEP_SOURCES)" ] || { echo "This archive was made without the browser's part; ask your teacher for one that has it." >&2; exit 1; }

# Of the window's flags.
TAB_STEPS = $(patsubst --steps=%,--steps %,$(filter --steps=%,$(subst --steps ,--steps=,$(FLAGS))))
TAB_SERVE = $(SERVE) $(TAB) --watch $(call quoted,$(CODE_SOURCE)) --code $(call quoted,$(TAB_CODE)) --build $(call quoted,$(TAB_COMPILE)) \
            --link $(call quoted,$(TAB_LINK)) --scene $(call quoted,$(notdir $(PREVIEW_SCENE))) $(STAGE_FLAGS) $(TAB_STEPS) $(if $(PORT),--port $(PORT))
TAB_OBJECTS = $(patsubst $(CODE_SOURCE)/%.c,$(TAB_CODE)/%.so,$(wildcard $(addprefix $(CODE_SOURCE)/,$(STEP_FILES))))
tab: all meshes code-there $(SERVE) $(TAB)/photonlab.wasm $(TAB)/tab.html $(TAB)/tab.js $(TAB_OBJECTS)

##check long check-tab  one's own code in a tab, in Chromium and Firefox, what of them is there: every fault, verdicts, what steps print (five minutes)
.PHONY: check-tab
check-tab: all meshes | $(SITE_TOOLS)
	@$(ON_DISPLAY) node tests/web/check_tab.mjs $(WASM) $(WASM)/shots

##check beside check-serve  attacks on the tab's server: other pages and names, paths, too much of anything
.PHONY: check-serve
check-serve: $(SERVE)
	@bash tests/web/attack_tab.sh $(SERVE)

##maintainer bench-tab  seconds from a save to new photons in the tab: the median of twenty
.PHONY: bench-tab
bench-tab: all meshes | $(SITE_TOOLS)
	@$(ON_DISPLAY) node tests/web/bench_tab.mjs $(WASM) $(WASM)/tab_bench
