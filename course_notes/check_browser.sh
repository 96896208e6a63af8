#!/usr/bin/env bash
# The notes in a real browser, 400 px wide as on a phone: does anything jut out, is every picture and formula visible?
# Usage: check_browser.sh BUILD
set -u
build=${1:-build}
. tests/common.sh
width=400
browser=""
for name in chromium chromium-browser google-chrome google-chrome-stable; do
    [ -n "$browser" ] || browser=$(command -v "$name")
done
if [ -z "$browser" ]; then
    echo "There is no chromium here to look at the notes with. On Debian: sudo apt-get install chromium" >&2
    exit 1
fi
flags=(--headless --disable-gpu --hide-scrollbars --user-data-dir="$work/profile" --virtual-time-budget=20000 --window-size=800,600)
[ "$(id -u)" != 0 ] || flags+=(--no-sandbox) # chromium's own sandbox does not work for root

# The page in a frame, which can be narrower than any window; beside it a script that measures. Folded answers are unfolded.
wrap() {
    printf '<!DOCTYPE html><meta charset="utf-8"><iframe style="width:%dpx;height:900px;border:0" srcdoc="' "$width"
    sed -e 's/&/\&amp;/g' -e 's/"/\&quot;/g' "$1"
    cat <<'SCRIPT'
"></iframe><pre id="said"></pre><script>
const frame = document.querySelector("iframe");
function measure() {
    const page = frame.contentDocument, root = page.documentElement, width = frame.clientWidth, said = [];
    const about = e => e.tagName.toLowerCase() + " " + (e.textContent || e.alt || "").replace(/\s+/g, " ").slice(0, 50);
    page.querySelectorAll("details").forEach(d => d.open = true);
    const inBox = e => { for (; e; e = e.parentElement) if (frame.contentWindow.getComputedStyle(e).overflowX === "auto") return true; };
    if (root.scrollWidth > width) said.push("BAD scrolls sideways: " + root.scrollWidth + " px");
    page.querySelectorAll("main *").forEach(e => {
        if (!inBox(e) && e.getBoundingClientRect().right > width + 0.5) said.push("BAD juts out: " + about(e));
    });
    const images = [...page.images], formulas = [...page.querySelectorAll("math")];
    images.forEach(i => { if (!(i.naturalWidth > 0 && i.getBoundingClientRect().height > 20)) said.push("BAD not visible: " + about(i)); });
    formulas.forEach(m => { if (m.getBoundingClientRect().height < 3) said.push("BAD without height: " + about(m)); });
    page.querySelectorAll(".wide > table").forEach(t => {
        const box = t.parentElement, scrolls = box.scrollWidth > box.clientWidth;
        if (!scrolls) return;
        t.style.cssText = "min-width: 0; width: max-content; white-space: nowrap";
        if (t.offsetWidth <= box.clientWidth) said.push("BAD scrolls, but would fit: " + about(t));
        t.style.cssText = "";
    });
    page.querySelectorAll("main *").forEach(e => {
        const style = frame.contentWindow.getComputedStyle(e);
        if (style.overflowX === "auto" && e.scrollWidth > e.clientWidth && !style.backgroundAttachment.includes("local"))
            said.push("BAD scrolls, and nothing shows it: " + about(e));
    });
    const texts = page.createTreeWalker(page.body, NodeFilter.SHOW_TEXT);
    formulas.filter(m => m.getAttribute("display") !== "block").forEach(m => {
        for (texts.currentNode = m; texts.nextNode() && m.contains(texts.currentNode););
        const range = page.createRange(), after = texts.currentNode, box = m.getBoundingClientRect();
        if (!/^[.,;:!?)]/.test(after.data)) return;
        range.setStart(after, 0);
        range.setEnd(after, 1);
        if (range.getBoundingClientRect().left < box.left) said.push("BAD its full stop is on the next line: " + about(m));
    });
    page.querySelectorAll("math mo:first-child").forEach(o => {
        const hole = o.getBoundingClientRect().left - o.closest("math").getBoundingClientRect().left;
        if (/^[a-z]{2,}$/.test(o.textContent) && o.closest("math[display=inline]") && o.parentElement.parentElement.tagName === "semantics" && hole > 2)
            said.push("BAD " + hole.toFixed(1) + " px before " + about(o.closest("math")));
    });
    if (root.scrollHeight < 200) said.push("BAD page is empty");
    const wide = [...page.querySelectorAll(".pieces")].filter(p => p.scrollWidth > p.clientWidth);
    wide.forEach(p => said.push("WIDE " + (p.scrollWidth - p.clientWidth) + " px: " + p.parentElement.id));
    said.push("SAID " + images.length + " images, " + formulas.length + " formulas, " + wide.length + " of " +
              page.querySelectorAll(".pieces").length + " on their own lines scroll, " + root.scrollHeight + " px high");
    document.getElementById("said").textContent = said.join("\n");
}
frame.onload = () => setTimeout(measure, 500);
</script>
SCRIPT
}

for page in "$build"/notes/*.html; do
    [ -f "course_notes/$(basename "$page" .html).md" ] || continue
    wrap "$page" >"$work/frame.html"
    "$browser" "${flags[@]}" --dump-dom "file://$work/frame.html" 2>"$work/errors" |
        sed -n '/<pre id="said">/,/<\/pre>/p' | sed 's/.*<pre id="said">//; s/<\/pre>.*//' >"$work/said"
    sum=$(sed -n 's/^SAID //p' "$work/said")
    name=$(basename "$page" .html)
    if [ -z "$sum" ]; then
        bad "$name: the browser did not say anything:"
        tail -3 "$work/errors"
    elif grep -q '^BAD' "$work/said"; then
        bad "$name: $sum:"
        grep '^BAD' "$work/said" | sed 's/^BAD/   /' | head -20
    else
        good "$name: $sum"
    fi
done
finish
