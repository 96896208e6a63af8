# Other machines and systems than this one; included by tests.mk. None is a part of `make check`: they fetch compilers and libraries.

.PHONY: check-macos check-elsewhere check-ci

# What Debian does not have comes from PyPI, in versions that are known to do, into a folder of its own.
ZIG = $(BUILD)/tools/ziglang-0.17.1
$(BUILD)/tools/%:
	$(call say,fetch,$*)
	$(call beside,python3 -m pip -q --disable-pip-version-check install --root-user-action=ignore --target $$new $(subst -0,==0,$*))

##check long check-macos  does it compile and link for a Mac?
# Reads a Mac's object files here, where it was built with the sanitizers.
$(BUILD)/object_names: tests/elsewhere/object_names.c $(addprefix tests/judge/submission/,object_macho.c object_file.c) lib/base/file.c lib/base/error.c
	$(call beside,$(CC) $(STANDARD) $(OPENMP) -g -fsanitize=address -fsanitize=undefined -Ilib -Itests $^ -o $$new)
check-macos: $(ZIG) $(BUILD)/object_names
	@bash tests/elsewhere/macos.sh $(BUILD) $(ZIG)/ziglang/zig $(BUILD)/object_names
