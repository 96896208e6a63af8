# The grader graded; included by the Makefile after judge.mk, whose STEP_FLAGS and PLUGIN say how a step is built.
.PHONY: check-grader check-grader-quick grader-table mistakes-table
GRADER = STEP_FLAGS="$(STEP_FLAGS)" STEP_LINK="$(PLUGIN)" COMPILER="$(CC)"

## check-grader-quick   is every known mistake caught, and named? (a few minutes)
check-grader-quick: judge
	@$(GRADER) bash tests/check_grader.sh quick $(BUILD)

## check-grader    the grader graded: mistakes, alternatives, compilers, false verdicts (long: an hour on two cores)
check-grader: judge
	@$(GRADER) bash tests/check_grader.sh quick $(BUILD)
	@$(GRADER) bash tests/check_grader.sh matrix $(BUILD)
	@$(GRADER) bash tests/check_grader.sh false-verdicts $(BUILD)
	@mkdir -p $(BUILD)/grader
	@bash tests/attacks/both.sh $(ATTACKS) >$(BUILD)/grader/attacks.txt; tail -1 $(BUILD)/grader/attacks.txt

# What check-grader found, into tests/README.md.
grader-table:
	@$(GRADER) bash tests/check_grader.sh write $(BUILD)

## mistakes-table  what the checks measure on each known mistake: tests/mistakes/features.txt, for the diagnosis (five minutes)
mistakes-table: judge
	@echo "measuring every known mistake: some minutes"
	@mkdir -p $(BUILD)/grader
	@$(GRADER) JUDGE_BUILD=$(abspath $(BUILD)) CASES=$(abspath $(BUILD))/grader/cases bash tests/judge/features_table.sh \
	    >$(BUILD)/grader/features.txt && mv $(BUILD)/grader/features.txt tests/mistakes/features.txt && \
	    echo "tests/mistakes/features.txt: $$(ls -d tests/mistakes/*/ | wc -l) mistakes measured. Next: make check-grader-quick"
