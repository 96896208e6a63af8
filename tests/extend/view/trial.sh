# A view that shows each photon as a short line to where it came from: the skeleton, under a name of its own.
most=1
sed -e 's/skeleton/needles/g; s/SKELETON/NEEDLES/g' lib/preview/view/view_skeleton.c.txt >lib/preview/view/view_needles.c
added lib/preview/view/view_needles.c "view_needles"
place lib/preview/view/views.def "VIEW(TREE" "VIEW(NEEDLES, needles)" "NEEDLES"

try() {
    local view
    build all meshes || return 1
    for view in points "needles --needles-length 0.2"; do
        build/photonlab preview scenes/box_glass.yaml --photons 2000 --snapshot "${view%% *}.png" --view $view 2>&1 || return 1
    done
    ! cmp -s points.png needles.png && build/photonlab preview --help | grep -F -- "--needles-length"
}
