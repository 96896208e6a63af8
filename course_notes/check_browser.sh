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
    if (root.scrollHeight < 200) said.push("BAD page is empty");
    said.push("SAID " + images.length + " images, " + formulas.length + " formulas, " + root.scrollHeight + " px high");
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
