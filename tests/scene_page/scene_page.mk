# The page of the scene format, and the fuzzer's words: both from the rows that scenes are read by.

SCENE_PAGE = $(BUILD)/scene_page
$(SCENE_PAGE): $(call object,$(wildcard tests/scene_page/*.c)) $(LIBRARY)
	$(call link)

.PHONY: scene-page check-scene-page
##maintainer scene-page  the page of the scene format, scenes/README.md, from the rows that scenes are read by
scene-page: $(SCENE_PAGE) meshes
	@$(SCENE_PAGE) >$(BUILD)/scene_page.md
	@mv $(BUILD)/scene_page.md scenes/README.md

##check first check-scene-page  is that page current, does each of its examples load, is every key used?
check-scene-page: $(SCENE_PAGE) meshes
	@$(SCENE_PAGE) >$(BUILD)/scene_page.md
	@diff -u scenes/README.md $(BUILD)/scene_page.md || { echo "scenes/README.md is not current: make scene-page"; exit 1; }
