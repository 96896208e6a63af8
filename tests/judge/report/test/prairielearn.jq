# true when the input is a results.json that PrairieLearn takes.
def text: type == "string";
def points: type == "number" and . >= 0;

(keys - ["gradable", "score", "message", "output", "images", "tests"] == [])
and (.gradable | type == "boolean") and (.score | points and . <= 1) and (.message | text) and (.output | text)
and (.tests | type == "array")
and all(.tests[];
    (keys - ["name", "description", "points", "max_points", "message", "output", "images"] == [])
    and (.name | text) and (.description | text) and (.message | text) and (.output | text))
# points on all tests or on none
and (all(.tests[]; (.points | points) and (.max_points | points) and .points <= .max_points)
    or all(.tests[]; has("points") or has("max_points") | not))
