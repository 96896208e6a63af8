# true when the input is a result that Classroom 50 takes: classroom50/result/v1 of its wiki.
def whole: type == "number" and . >= 0 and . == floor;

.schema == "classroom50/result/v1" and ([.classroom, .assignment, .submission, .commit, .release, .review] | all(type == "string"))
and (.datetime | test("^[0-9-]{10}T[0-9:]{8}Z$")) and (.score | whole) and (."max-score" | whole)
and .score == ([.tests[].score] | add // 0) and ."max-score" == ([.tests[]."max-score"] | add // 0)
and all(.tests[]; (."test-name" | type == "string") and (.passed | type == "boolean") and (.score | whole) and (."max-score" | whole))
