# true when the input is a results.json that Gradescope takes.
def text: type == "string";
def points: type == "number" and . >= 0;
def format: . == "text" or . == "html" or . == "simple_format" or . == "md" or . == "ansi";
def visibility: . == "visible" or . == "hidden" or . == "after_due_date" or . == "after_published";

(keys - ["score", "execution_time", "output", "output_format", "visibility", "stdout_visibility", "tests",
    "leaderboard"] == [])
and ((.execution_time // 0) | points) and ((.output // "") | text) and ((.output_format // "text") | format)
and ((.visibility // "visible") | visibility) and ((.stdout_visibility // "hidden") | visibility)
and (.tests | type == "array") and ((.tests | length) > 0 or (.score | points))
and ((has("score") | not) or (.tests | length) == 0)
and all(.tests[];
    (keys - ["score", "max_score", "status", "name", "number", "output", "output_format", "tags", "visibility",
        "extra_data"] == [])
    and (.score | points) and (.max_score | points) and .score <= .max_score
    and (.status == "passed" or .status == "failed") and (.name | text) and (.number | text) and (.output | text)
    and (.output_format | format) and (.tags | type == "array" and all(.[]; text)) and (.visibility | visibility)
    and (.extra_data | type == "object"))
