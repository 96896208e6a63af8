# true when the input is a result that GitHub Classroom's reporter takes.
def status: . == "pass" or . == "fail" or . == "error";

(keys == ["max_score", "status", "tests", "version"]) and .version == 1 and (.status | status)
and (.max_score | type == "number" and . >= 0)
and all(.tests[]; keys == ["message", "name", "score", "status"] and (.name | type == "string") and (.status | status)
    and (.score | type == "number" and . >= 0) and (.message | type == "string"))
