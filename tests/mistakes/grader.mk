# The grader graded; included by tests/tests.mk.
.PHONY: check-grader check-grader-quick check-fresh grader-table mistakes-table

##check first check-grader-quick  is every known mistake caught, and named?
check-grader-quick: judge
	@$(if $(CHECK),HANDS=b EVERY=18) bash tests/check_grader.sh quick

##check long check-grader  mistakes, alternatives, compilers, false verdicts (an hour)
check-grader: judge
	@for part in quick matrix false-verdicts; do bash tests/check_grader.sh $$part || exit; done
	@mkdir -p $(BUILD)/grader
	@bash tests/attacks/everywhere.sh $(ATTACKS) >$(BUILD)/grader/attacks.txt; tail -1 $(BUILD)/grader/attacks.txt

##check long check-fresh  mistakes that the diagnosis was not made from: how many does it name? (five minutes)
check-fresh: judge
	@bash tests/mistakes/fresh_mistakes.sh

##maintainer grader-table  what check-grader found, into tests/README.md
grader-table:
	@bash tests/check_grader.sh write

##maintainer mistakes-table  what known mistakes measure: tests/mistakes/features.txt (five minutes)
mistakes-table: judge
	@echo "measuring every known mistake: some minutes"
	@mkdir -p $(BUILD)/grader
	@CASES=$(abspath $(BUILD))/grader/cases bash tests/mistakes/features_table.sh \
	    >$(BUILD)/grader/features.txt && mv $(BUILD)/grader/features.txt tests/mistakes/features.txt && \
	    echo "tests/mistakes/features.txt: $$(ls -d tests/mistakes/*/ | wc -l) mistakes measured. Next: make check-grader-quick"
