#!/usr/bin/env python3
"""The autograder for Classroom 50, which calls it in a student's checkout: CLASSROOM/autograders/ASSIGNMENT/autograder.py,
with the students' archive (photonlab-….tar.gz, by `make handout`) beside it. Writes result.json.

With a report.json as argument it only turns that into result.json, to try it."""

import datetime
import json
import os
import pathlib
import shutil
import subprocess
import sys
import tarfile
import tempfile
import time


def grade(checkout):
    """Grades checkout/exercises by a judge of our own, whatever the checkout's is; returns the report."""
    archives = list(pathlib.Path(__file__).resolve().parent.glob("photonlab-*.tar.gz"))
    if len(archives) != 1:
        sys.exit(f"expected one photonlab-….tar.gz beside autograder.py, found {len(archives)}")
    work = pathlib.Path(tempfile.mkdtemp())
    with tarfile.open(archives[0]) as archive:
        archive.extractall(work)
    lab = next(work.glob("photonlab-*"))
    # Ubuntu forbids what the judge's sandbox is made of, unless this is set.
    if shutil.which("sudo"):
        subprocess.run(["sudo", "sysctl", "-q", "-w", "kernel.apparmor_restrict_unprivileged_userns=0"], check=False)
    subprocess.run(["make", "setup"], cwd=lab, check=True)
    subprocess.run(["make", "report", f"CODE={checkout / 'exercises'}"], cwd=lab, check=False)  # not 0 where a step is wrong
    return lab / "build" / "report" / "report.json"


def tests_of(report):
    """A test for each step; hidden ones are one test without words. Scores are whole numbers there: hundredths of a point."""
    tests = []
    hidden = {"test-name": "hidden steps", "passed": True, "score": 0, "max-score": 0}
    for step in report["steps"]:
        score = round(100 * step["points"]) if report["credit"] else 0
        most = round(100 * step["points_max"])
        passed = step["status"] == "pass"
        if step["hidden"]:
            hidden["passed"] = hidden["passed"] and passed
            hidden["score"] += score
            hidden["max-score"] += most
        else:
            tests.append({"test-name": f"{step['id']} {step['title']}", "passed": passed, "score": score, "max-score": most,
                          "message": step["message"]})
    return tests + ([hidden] if hidden["max-score"] > 0 else [])


def main():
    path = pathlib.Path(sys.argv[1]) if len(sys.argv) > 1 else grade(pathlib.Path.cwd())
    tests = tests_of(json.loads(path.read_text(encoding="utf-8")))
    told = {key: os.environ.get(name, "") for key, name in (
        ("classroom", "CLASSROOM"), ("assignment", "ASSIGNMENT"), ("submission", "SUBMISSION_TAG"), ("commit", "COMMIT_URL"),
        ("release", "RELEASE_URL"), ("review", "REVIEW_URL"))}
    told["review"] = told["review"] or told["commit"]
    # When the work was handed in, whenever it is graded: the commit's time.
    commit = subprocess.run(["git", "show", "-s", "--format=%ct", "HEAD"], capture_output=True, text=True, check=False)
    then = datetime.datetime.fromtimestamp(int(commit.stdout or time.time()), datetime.timezone.utc).strftime("%Y-%m-%dT%H:%M:%SZ")
    result = {"schema": "classroom50/result/v1", **told, "datetime": then, "score": sum(t["score"] for t in tests),
              "max-score": sum(t["max-score"] for t in tests), "tests": tests}
    pathlib.Path("result.json").write_text(json.dumps(result, indent=1), encoding="utf-8")


main()
