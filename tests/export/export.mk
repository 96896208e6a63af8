# Scenes exported to other renderers; included by tests.mk.

# Mitsuba 3, in a folder of its own. Where it cannot be had, the check says so.
MITSUBA = $(BUILD)/mitsuba/bin/python
$(MITSUBA):
	@{ python3 -m venv $(BUILD)/mitsuba && $(BUILD)/mitsuba/bin/pip -q install mitsuba==3.9.1; } >/dev/null 2>&1 || rm -rf $(BUILD)/mitsuba

.PHONY: check-export check-tev
##check long check-export  exported scenes rendered by Mitsuba 3, against the path tracer; files for pbrt-v4; takes Mitsuba from PyPI (three minutes)
check-export: all meshes $(MITSUBA)
	@bash tests/export/check.sh $(PROGRAM) $(MITSUBA)

##check beside check-tev  a live picture in the viewer tev is the picture that is saved
check-tev: all
	@bash tests/export/tev.sh $(PROGRAM)
