# The page of the scene format, and the fuzzer's words: both from the rows that scenes are read by.

SCENE_PAGE = $(BUILD)/scene_page
$(SCENE_PAGE): $(call object,$(wildcard tests/scene_page/*.c)) $(LIBRARY)
	$(call say,link,$@)
	$(Q)$(CC) $(CFLAGS) $(filter %.o,$^) -L$(BUILD) -lphotonlab -Wl,-rpath,'$(ORIGIN)' -o $@ $(LDLIBS)

.PHONY: scene-page check-scene-page
## scene-page      write scenes/README.md, the page of the scene format, from the keys that the program knows
scene-page: $(SCENE_PAGE) meshes
	@$(SCENE_PAGE) >$(BUILD)/scene_page.md
	@mv $(BUILD)/scene_page.md scenes/README.md

##   check-scene-page  is that page current, does each of its examples load, is every key used?
check-scene-page: $(SCENE_PAGE) meshes
	@$(SCENE_PAGE) >$(BUILD)/scene_page.md
	@diff -u scenes/README.md $(BUILD)/scene_page.md || { echo "scenes/README.md is not current: make scene-page"; exit 1; }
