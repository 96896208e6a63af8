# The autograder for Gradescope. To be sourced by class.sh.

check_gradescope() {
    local place=$work/autograder
    PHOTONLAB_OUT=$work/gradescope bash "$here/gradescope.sh" >"$work/said" 2>&1 ||
        bad "gradescope: $(cat "$work/said")"
    mkdir -p "$place/source" "$place/submission"
    (cd "$place/source" && unzip -q "$work/gradescope/autograder.zip")
    ok "gradescope: both scripts at the root, executable" test -x "$place/source/setup.sh" -a -x \
        "$place/source/run_autograder"
    mkdir "$place/source/photonlab/build" &&
        cp -R "$build/obj" "$build"/*.so "$build/photonlab" "$build/probe" "$build/judge" "$build"/class_* \
        "$build/write_reports" "$build/solutions" "$place/source/photonlab/build/" &&
            find "$place/source/photonlab/build" -type f -exec touch {} +
    cp "$root"/scenes/meshes/*.obj "$place/source/photonlab/scenes/meshes/" &&
        touch "$place/source/photonlab/scenes/meshes/"*
    AUTOGRADER_ROOT=$place NO_PACKAGES=1 "$place/source/setup.sh" >"$work/said" 2>&1 ||
        bad "gradescope: setup.sh: $(tail -5 "$work/said")"
    check "$(find "$place/source/photonlab/solutions" -perm /077 | wc -l) == 0" \
        "gradescope: solutions are for root alone"
    autograde() { AUTOGRADER_ROOT=$place "$@" "$place/source/run_autograder" >"$work/said" 2>&1; }
    points() { sed -n 's/.*"score": *\([0-9.]*\).*/\1/p' "$place/results/results.json" |
        awk '{ sum += $1 } END { print sum + 0 }'; }

    autograde env
    says '"score": 0, "output": "Your submission cannot be graded: the folder is empty"' \
        "$place/results/results.json" "gradescope: nothing handed in"
    cp "$solved/$turn" "$place/submission/"
    autograde env
    check "$(points) == 5" "gradescope: a loose file gets its points"
    rm "$place/submission/"* && cp "$work/first" "$place/submission/mine.tar.gz"
    local plain=() # a container as it usually is: root, and all can be read by all
    [ "$(id -u)" != 0 ] || plain=(PHOTONLAB_SANDBOX=uid)
    chmod 755 "$work" "$place" "$place/source" "$place/source/photonlab/solutions" "$place/source/photonlab/build/solutions"
    autograde env "${plain[@]}"
    check "$(points) == 5" "gradescope: an archive by make submit, too${plain:+, where solutions were open to all}"
    [ -z "${plain:-}" ] || check "$(find "$place/source/photonlab/solutions" -maxdepth 0 -perm /077 | wc -l) == 0" \
        "gradescope: which the judge has closed"
    check "$(wc -c <"$place/source/salt") >= 36" "gradescope: random numbers of its own"
    cp "$place/source/salt" "$work/salt"
    PHOTONLAB_OUT=$work/gradescope bash "$here/gradescope.sh" >/dev/null 2>&1
    unzip -p "$work/gradescope/autograder.zip" salt | cmp -s - "$work/salt" &&
        good "gradescope: the same when it is made again" || bad "gradescope: another salt when made again"
    says '2.2 Turn' "$place/results/results.json" "gradescope: its results name the steps"
    rm "$place/submission/"* && cp "$work"/odd/late/*.c "$work"/odd/late/*/*.c "$place/submission/"
    autograde env PATH="$work/bin:$PATH"
    check "$(points) == 9" "gradescope: what was graded before the time ran out counts"
    says '"output": "The time for grading ran out' "$place/results/results.json" "gradescope: and it says so"
    rm -f "$place/results/results.json"
    (autograde exec setsid) 2>/dev/null &
    until [ -s "$place/results/results.json" ] || ! kill -0 $! 2>/dev/null; do sleep 0.02; done
    kill -9 -- "-$!" 2>/dev/null
    wait $! 2>/dev/null
    says '"score": 0, "output": "Grading did not come to its end' "$place/results/results.json" \
        "gradescope: killed, it leaves no points, and a valid file"
}
