# The course notes: course_notes/*.md become pages in $(BUILD)/notes/. Included by the Makefile.

NOTES_SOURCES = $(filter-out %/index.md $(NOTES_WITHOUT:%=\%/%.md),$(wildcard course_notes/*.md))
# Where the pages go; of a site, they have live figures.
NOTES         = $(BUILD)/notes
NOTES_PAGES   = $(patsubst course_notes/%.md,$(NOTES)/%.html,$(NOTES_SOURCES) $(wildcard course_notes/index.md))
NOTES_TOOLS   = $(addprefix course_notes/,make_page.sh template.html style.css figure.lua words.lua formula.lua paper.lua word_index.lua)
NOTES_FIGURES = $(wildcard course_notes/figures/*.*)
NOTES_HELPERS = $(patsubst course_notes/figures/src/%.c,$(BUILD)/figures/%,$(wildcard course_notes/figures/src/*.c))
PANDOC       := $(shell command -v pandoc 2>/dev/null)

.PHONY: notes publish notes-pages notes-pandoc notes-list figures figure-helpers check-notes check-figures check-notes-browser

notes-pandoc:
	@command -v pandoc >/dev/null || { echo "The notes are made by pandoc, which is not here. On Debian: sudo apt-get install pandoc" >&2; exit 1; }

# Which chapters there are, in order, with their titles: touched only when that changes, since every page names its neighbours.
notes-list:
	@mkdir -p $(NOTES)
	@for page in $(NOTES_SOURCES); do printf '%s\t%s\n' "`basename $$page .md`" \
	    "`sed -n '/^# /{s/^# *//; s/ *{[^}]*}$$//; p; q;}' $$page`"; done | LC_ALL=C sort >$(NOTES)/.pages.new
	@cmp -s $(NOTES)/.pages.new $(NOTES)/.pages || cp $(NOTES)/.pages.new $(NOTES)/.pages
$(NOTES)/.pages: notes-list ;

# A page holds its figures.
.SECONDEXPANSION:
$(NOTES)/%.html: course_notes/%.md $(NOTES)/.pages $(NOTES_TOOLS) $$(if $$(PANDOC),,notes-pandoc) \
                       $$(filter course_notes/figures/$$(firstword $$(subst _, ,$$*))_%,$$(NOTES_FIGURES)) \
                       $$(if $$(filter index word_index,$$*),$$(NOTES_SOURCES)) $$(NOTES_MODULE) $$(if $$(NOTES_MODULE),$$(wildcard web/page/* web/figures/* web/figures/live/*))
	$(call say,pandoc,$<)
	$(Q)sh course_notes/make_page.sh $(NOTES) $* $(NOTES_MODULE)

notes-pages: notes-pandoc $(NOTES_PAGES)

## notes  the course notes: build/notes/index.html; where there is a TeX, photonlab.pdf too
notes: notes-pages
	@bash course_notes/make_pdf.sh $(BUILD)
	@echo "$(BUILD)/notes/index.html"

##maintainer publish  the notes without the teachers' page, for everybody: build/public/notes/
publish:
	+@$(MAKE) --no-print-directory notes BUILD=$(BUILD)/public NOTES_WITHOUT=teachers

# Programs that compute what a figure shows.
$(BUILD)/figures/%: $(BUILD)/obj/course_notes/figures/src/%.o $(LIBRARY)
	$(call link)
figure-helpers: $(NOTES_HELPERS)

##maintainer figures  the notes' figures anew: [CHAPTER=2] [FIGURE=2_lobe.svg] [FORCE=1]
figures: export CHAPTER := $(CHAPTER)
figures: export FIGURE := $(FIGURE)
figures: export FORCE := $(FORCE)
figures: notes-pandoc all meshes figure-helpers
	@bash course_notes/make_figures.sh

##check beside check-notes  links, anchors, figures, numbers, formulas of the course notes
check-notes: notes-pages $(if $(wildcard tests/judge),judge $(WRITE_REPORTS))
	@bash course_notes/check_notes.sh $(BUILD)

##check long check-figures  every figure made anew: the same bytes? (a quarter of an hour)
check-figures: notes-pandoc all meshes figure-helpers
	@bash course_notes/make_figures.sh check

##check long check-notes-browser  the notes on a phone: nothing juts out (needs chromium)
check-notes-browser: notes-pages
	@bash course_notes/check_browser.sh $(BUILD)
