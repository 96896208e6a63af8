// The preview's view: wireframes, colours, what is chosen of the photons.
#include "unit/preview/view_helpers.h"

#include <dirent.h>

static size_t wire_lines(const char *name, Box *box)
{
    Scene *scene = scene_from_file(name);
    Vertices list = {.items = NULL};
    wireframe_build(scene, &list);
    *box = box_empty();
    for (size_t i = 0; i < list.count; i++)
        box_add_point(box, vec3(list.items[i].x, list.items[i].y, list.items[i].z));
    size_t lines = list.count / 2;
    vertices_free(&list);
    return lines;
}

TEST(wires_show_edges_and_leave_meshes_light)
{
    Box box;
    // The open room's 12 edges, the lamp's 4, and two spheres of 7 circles with 64 parts.
    assert_int_equal(wire_lines("scenes/box_diffuse.yaml", &box), 12 + 4 + 2 * 7 * 64);
    assert_true(fabsf(box.low.x + 1) < 1e-3f && fabsf(box.high.y - 1) < 1e-3f);
    size_t lines = wire_lines("scenes/bumpy_glass.yaml", &box);
    assert_true(lines > 1000 && lines < 4000); // a round mesh: few of its 100000s of edges
}

TEST(brightness_does_not_depend_on_the_number)
{
    float pixels = 400000;
    float few = 50000 * points_exposure(50000, pixels, 3), many = 5e5f * points_exposure(500000, pixels, 1);
    assert_true(fabsf(9 * points_exposure(100000, pixels, 3) * 100000 / many - 1) < 1e-3f);
    assert_true(few > 0 && points_exposure(10, pixels, 1) == 1.0f);
    Colour power = {2e-5f, 1e-5f, 0};
    Rgba a = rgba_of_power(power, 2e-5f), b = rgba_of_power(colour_scale(power, 0.01f), 2e-7f);
    assert_true(a.r == b.r && abs(a.g - b.g) <= 1 && a.b == b.b);
    assert_int_equal(a.r, 255);
    assert_true(a.g > 100 && a.g < 160 && a.b == 0);
    Rgba dark = rgba_of_power(colour(NAN, -1, 0), 1);
    assert_int_equal(dark.r, 0);
}

TEST(the_prisms_colours_choose_the_screen)
{
    Scene *scene = scene_from_file("scenes/prism.yaml");
    Recording recording = recording_of(scene, 20000);
    int surface = screen_busiest(scene, &recording);
    assert_true(surface >= 0);
    const Flat *flat = &scene->flats[surface];
    assert_string_equal(scene->materials[flat->material].name, "screen");
    // Behind the prism, the colours lie apart across it: their middles differ, in order.
    double sums[4] = {0}, counts[4] = {0};
    for (size_t i = 0; i < recording.count; i++) {
        float u, v;
        const StoredPhoton *photon = &recording.photons[i].at;
        if (!screen_place(flat, (uint8_t)flat->material, photon, 1e-4f, &u, &v))
            continue;
        assert_true(u > -0.01f && u < 1.01f && v > -0.01f && v < 1.01f);
        Vec3 again = vec3_along(vec3_along(flat->origin, flat->edge_u, u), flat->edge_v, v);
        assert_true(vec3_length(vec3_sub(again, photon->position)) < 2e-4f);
        if (photon->bounce > 3)
            continue;
        sums[photon->colour] += (double)u;
        counts[photon->colour]++;
    }
    for (int c = RED; c <= BLUE; c++)
        assert_true(counts[c] > 100);
    double red = sums[RED] / counts[RED], green = sums[GREEN] / counts[GREEN], blue = sums[BLUE] / counts[BLUE];
    assert_true((red < green && green < blue) || (red > green && green > blue));
    assert_true(fabs(blue - green) > fabs(green - red)); // normal dispersion: blue is bent the most
    recording_free(&recording);
}

TEST(cells_hold_every_photon_once)
{
    Scene *scene = scene_from_file("scenes/box_diffuse.yaml");
    Recording recording = recording_of(scene, 3000);
    StoredPhoton *photons = malloc((recording.count + 1) * sizeof *photons);
    assert_non_null(photons);
    for (size_t i = 0; i < recording.count; i++)
        photons[i] = recording.photons[i].at;
    PhotonMap *map = photon_map_build(photons, recording.count, &said);
    assert_non_null(map);
    for (int level = 0; level <= tree_depth(map); level++) {
        size_t seen = 0;
        for (size_t i = 0; i < (size_t)1 << level; i++) {
            size_t count;
            Box box = tree_cell(map, level, i, &count);
            assert_true(count <= (recording.count >> level) + 1);
            for (size_t p = seen; p < seen + count; p++) {
                Vec3 at = photon_map_photons(map)[p].position;
                assert_true(at.x >= box.low.x && at.x <= box.high.x && at.y >= box.low.y && at.y <= box.high.y &&
                            at.z >= box.low.z && at.z <= box.high.z);
            }
            seen += count;
        }
        assert_int_equal(seen, recording.count);
    }
    photon_map_free(map);
    recording_free(&recording);
}

TEST(legs_are_found_and_cut_at_the_front)
{
    PathLeg legs[5] = {{.path = 3, .flown = 0, .to = {2, 0, 0}},
                       {.path = 3, .flown = 2, .to = {0, 4, 0}, .bounce = 1},
                       {.path = 5, .flown = 0, .to = {1, 0, 0}},
                       {.path = 8, .flown = 0, .to = {1, 0, 0}},
                       {.path = 8, .flown = 1, .to = {1, 0, 0}}};
    Recording recording = {.legs = legs, .leg_count = 5};
    size_t count;
    assert_ptr_equal(path_legs(&recording, 3, &count), legs);
    assert_int_equal(count, 2);
    assert_ptr_equal(path_legs(&recording, 8, &count), legs + 3);
    assert_int_equal(count, 2);
    assert_null(path_legs(&recording, 4, &count));
    assert_int_equal(count, 0);
    assert_true(leg_flown(&legs[1], -1) == 1.0f);
    assert_true(leg_flown(&legs[1], 1.5) == 0.0f);
    assert_true(fabsf(leg_flown(&legs[1], 3.0) - 0.25f) < 1e-6f);
    assert_true(leg_flown(&legs[1], 100.0) == 1.0f);
}

TEST(words_fit)
{
    const char *text = "200000 photons, 614409 stored, up to 32 bounces, 0.53 s | your code: 1.1 1.2 1.3 1.4 | "
                       "averyveryveryverylongnamewithoutanyspaceinitaveryveryveryverylongname.c:12:5: error: no";
    for (int most = 1; most < 9; most++)
        for (float scale = 1; scale <= 2; scale++) {
            char wrapped[1024];
            int lines = overlay_wrap(text, scale, 388, most, wrapped, sizeof wrapped), counted = 0;
            for (char *line = strtok(wrapped, "\n"); line; line = strtok(NULL, "\n")) {
                assert_true(canvas_text_width(scale, line) <= 388);
                counted++;
                if (counted == most && most < 3)
                    assert_string_equal(line + strlen(line) - 2, "..");
            }
            assert_int_equal(lines, counted);
            assert_true(lines <= most);
        }
    char small[16], path[] = "exercises/1_diffuse_photon_map/1.6_estimate_radiance.c", wrapped[64];
    assert_int_equal(overlay_wrap(path, 1, 388, 3, wrapped, sizeof wrapped), 2);
    assert_string_equal(strchr(wrapped, '\n'), "\n1.6_estimate_radiance.c");
    overlay_wrap(text, 1, 388, 3, small, sizeof small);
    assert_true(strlen(small) < sizeof small);
}

// What a view must not leave out, by name; and that no file of a view is left out of the list.
TEST(every_view_is_whole_and_listed)
{
    for (int i = 0; i < VIEW_COUNT; i++) {
        const ViewType *type = view_types[i];
        const char *missing = !type->help                                       ? "help"
                              : !type->draw                                     ? "draw"
                              : !type->describe                                 ? "describe"
                              : !type->arrows != !type->choose                  ? "arrows or choose"
                              : type->place == IN_THE_SCENE && type->wires <= 0 ? "wires"
                                                                                : NULL;
        if (missing)
            fail_msg("the ViewType of view %d, %s, has no %s", i + 1, view_names[i], missing);
        for (int j = 0; j < MOST_SETTINGS; j++)
            if (type->settings[j].key && !type->settings[j].words)
                fail_msg("--%s of view %s has a key and no words", type->settings[j].flag, view_names[i]);
    }
    DIR *folder = opendir("lib/preview/view");
    assert_non_null(folder);
    for (struct dirent *entry; (entry = readdir(folder));) {
        char name[64] = "";
        size_t length = strlen(entry->d_name);
        if (sscanf(entry->d_name, "view_%60[a-z0-9_]", name) != 1 || strcmp(entry->d_name + length - 2, ".c") != 0)
            continue;
        int kind = 0;
        while (kind < VIEW_COUNT && strcmp(view_names[kind], name) != 0)
            kind++;
        if (kind == VIEW_COUNT)
            fail_msg("lib/preview/view/%s: views.def has no view of this name", entry->d_name);
    }
    closedir(folder);
}
