#!/usr/bin/env python3
"""Which submissions share more steps than chance would have it? `make class-alike` runs this after `make class`.

Usage: alike.py ROOT BUILD OUT; writes OUT/alike.html, for the teacher, to look with, and never a verdict.
Two steps are the same when copydetect (https://github.com/blingenf/copydetect) makes the same of them: it takes away comments
and layout, and all names become one. How often that happens by chance the class itself tells, and the right solutions in tests/."""

import collections
import concurrent.futures
import functools
import html
import pathlib
import subprocess
import sys
import tempfile
import urllib.parse

import numpy
from copydetect.utils import filter_code

LISTED = 0.05  # a pair is listed when chance would make fewer than so many like it in the whole class


def forms_in(folder):
    """The form of each started step below: {"1.1": "…"}."""
    forms = {}
    for path in sorted(folder.rglob("[0-9]*.c")):
        code = path.read_text(encoding="utf-8", errors="replace")
        if "todo(" not in code:
            forms[path.name.split("_")[0]] = filter_code(code, "step.c")[0]
    return forms


def forms_of(unpack, path):
    with tempfile.TemporaryDirectory() as place:
        subprocess.run([unpack, path, place], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, timeout=60, check=False)
        return forms_in(pathlib.Path(place))


def submissions(out, build):
    """Names and forms of all that `make class` has listed."""
    fields = (out / ".parts" / ".list").read_bytes().decode("utf-8", "surrogateescape").split("\0")[:-1]
    paths = list(dict.fromkeys(fields[::2]))
    with concurrent.futures.ProcessPoolExecutor() as pool:
        forms = dict(zip(paths, pool.map(functools.partial(forms_of, build / "class_unpack"), paths, chunksize=8)))
    return fields[1::2], [forms[path] for path in fields[::2]]


def same_of_right(root, step):
    """Of the pairs of right solutions by different hands, how many are the same, and how many there are."""
    files = list(root.glob(f"solutions/*/{step}_*.c")) + sorted(root.glob(f"tests/alternatives/*/{step}_*/*.c"))
    counts = collections.Counter(filter_code(f.read_text(encoding="utf-8"), "step.c")[0] for f in files)
    return sum(n * (n - 1) // 2 for n in counts.values()), len(files) * (len(files) - 1) // 2


def chance_of(rates):
    """The chance of k same steps, for each k, if steps were the same independently of each other."""
    chances = numpy.array([1.0])
    for rate in rates:
        chances = numpy.convolve(chances, [1 - rate, rate])
    return chances


def compare(forms, steps):
    """Numbers of forms (0: not started), pairs that share so many steps, the pairs with most."""
    numbers = [{} for _ in steps]
    table = numpy.zeros((len(forms), len(steps)), dtype=numpy.int32)
    for row, form in enumerate(forms):
        for column, step in enumerate(steps):
            if step in form:
                table[row, column] = numbers[column].setdefault(form[step], len(numbers[column]) + 1)
    pairs = numpy.zeros(len(steps) + 1, dtype=numpy.int64)
    alike = numpy.zeros(len(steps), dtype=numpy.int64)
    most = []
    for row in range(len(forms) - 1):
        same = (table[row] == table[row + 1:]) & (table[row] > 0)
        alike += same.sum(axis=0)
        shared = same.sum(axis=1)
        pairs += numpy.bincount(shared, minlength=len(steps) + 1)
        most += [(int(shared[i]), row, row + 1 + int(i)) for i in numpy.flatnonzero(shared > 1)[:100]]
        most = sorted(most, reverse=True)[:2000]
    return table, alike, pairs, most


def groups_of(pairs):
    """Who hangs together by these pairs: lists of rows, the largest first."""
    group = {}
    for _, a, b in pairs:
        joined = group.get(a, [a]) + [x for x in group.get(b, [b]) if x not in group.get(a, [a])]
        group.update(dict.fromkeys(joined, joined))
    return sorted({id(g): sorted(g) for g in group.values()}.values(), key=len, reverse=True)


def link(name, out):
    text = html.escape(name.encode("utf-8", "replace").decode())
    there = (out / name / "index.html").exists()
    return f'<a href="{urllib.parse.quote(name, errors="surrogateescape")}/index.html">{text}</a>' if there else text


def main():
    root, build, out = (pathlib.Path(a).resolve() for a in sys.argv[1:4])
    names, forms = submissions(out, build)
    steps = sorted({step for form in forms for step in form})
    table, alike, pairs, most = compare(forms, steps)
    of_all = max(1, int(pairs.sum()))
    expected = chance_of(alike / of_all) * of_all
    at_least = numpy.cumsum(expected[::-1])[::-1]
    page = ["<!DOCTYPE html><html lang=en><meta charset=utf-8><title>photonlab: the same steps</title><style>"
            "body{font:15px/1.4 system-ui,sans-serif;margin:2em;max-width:60em}td,th{padding:.1em .6em;text-align:left}"
            "td.n{text-align:right}</style><h1>The same steps</h1><p>For the teacher, to look with. <b>It proves nothing:</b> short "
            "steps come out alike by themselves, more so where a lecture showed them, and friends who learnt together write alike. "
            "Two steps are the same here when they are the same but for names, comments and layout.</p>",
            f"<h2>More in common than chance would have it</h2><p>{len(names)} submissions, {int(pairs.sum())} pairs. Two belong "
            f"to a group when they share so many steps that chance would make fewer than {LISTED} such pairs in the class, if each step "
            "were the same as often as the table below says and steps knew nothing of each other.</p>"
            "<table><tr><th>two share<th>who<th>the same in all"]
    listed = [pair for pair in most if at_least[pair[0]] < LISTED]
    groups = groups_of(listed)
    for rows in groups:
        shared = [count for count, a, _ in listed if a in rows]
        which = [step for i, step in enumerate(steps) if table[rows[0], i] > 0 and (table[rows, i] == table[rows[0], i]).all()]
        page.append(f"<tr><td class=n>{min(shared)}–{max(shared)}<td>{' · '.join(link(names[r], out) for r in rows)}"
                    f"<td>{' '.join(which)}")
    page.append("</table>" if groups else "</table><p>None.</p>")
    page.append("<h2>How many steps do two share?</h2><table><tr><th>steps<th>pairs<th>by chance")
    page += [f"<tr><td class=n>{k}<td class=n>{pairs[k]}<td class=n>{expected[k]:.2g}" for k in range(len(steps) + 1) if pairs[k] or k < 3]
    page.append("</table><h2>How telling is a step?</h2><p>In how many ways the class wrote it, how many pairs of the class are the same, "
                "and how many pairs of the right solutions that photonlab's tests have; those were written to differ.</p>"
                "<table><tr><th>step<th>began<th>ways<th>the same in the class<th>the same in the tests")
    for i, step in enumerate(steps):
        same, right = same_of_right(root, step)
        page.append(f"<tr><td>{step}<td class=n>{int((table[:, i] > 0).sum())}<td class=n>{int(table[:, i].max())}"
                    f"<td class=n>{100 * alike[i] / of_all:.1f} %<td class=n>{same} of {right}")
    (out / "alike.html").write_text("\n".join(page) + "</table></html>\n", encoding="utf-8")
    print(f"{len(groups)} groups share more than chance would have it: {out}/alike.html")


main()
