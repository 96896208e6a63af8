// Every malformed scene and mesh is refused, at the right place and in the right words, without a crash (run this under
// sanitizers too). Works from the top folder: tests/malformed/ holds one small file per fault, expected.inc the words.
#include "unit/scene/scene_parts.h"

#include <dirent.h>
#include <sys/stat.h>

#define FOLDER "tests/malformed/"

static const struct {
    const char *file, *expected;
} faults[] = {
#include "malformed/expected.inc"
};
enum { FAULTS = sizeof faults / sizeof faults[0] };

static bool is_refused(Scene *scene, const char *file, const char *expected)
{
    bool right = !scene && strstr(said.message, expected) && strstr(said.message, file);
    if (!right)
        print_error("%s: expected '%s', got '%s'\n", file, expected, scene ? "a scene" : said.message);
    scene_free(scene);
    said = (Error){""};
    return right;
}

static bool ends_with(const char *text, const char *end)
{
    size_t length = strlen(text), end_length = strlen(end);
    return length >= end_length && strcmp(text + length - end_length, end) == 0;
}

static bool scene_refused(const char *path, const char *expected)
{
    return is_refused(scene_load(path, &said), path, expected);
}

// A mesh is loaded by a scene without a fault.
static bool mesh_refused(const char *folder, const char *file, const char *expected)
{
    const char *text = words(CAMERA LIGHT "materials:\n  - {name: white, type: mirror}\n"
                                          "shapes:\n  - {type: mesh, file: %s, material: white}\n",
                             file);
    return is_refused(scene_load_text(text, strlen(text), "scene.yaml", folder, &said), file, expected);
}

TEST(test_files)
{
    int wrong = 0;
    for (int i = 0; i < FAULTS; i++) {
        const char *path = words(FOLDER "%s", faults[i].file);
        const char *expected = words("%s%s", faults[i].file, faults[i].expected);
        wrong +=
            ends_with(path, ".yaml") ? !scene_refused(path, expected) : !mesh_refused(FOLDER, faults[i].file, expected);
    }
    assert_int_equal(wrong, 0);
}

// The two meshes that have nothing wrong are the only ones without a line in the table.
TEST(test_no_file_is_forgotten)
{
    DIR *folder = opendir(FOLDER);
    assert_non_null(folder);
    int count = 0;
    for (struct dirent *entry; (entry = readdir(folder));)
        count += ends_with(entry->d_name, ".yaml") || ends_with(entry->d_name, ".obj");
    closedir(folder);
    assert_int_equal(count, FAULTS + 2);
}

// What is too large, too deep or no file at all is made in a folder.
static const char *temporary_path(const char *name)
{
    return words("%s/%s", temporary, name);
}

// `head`, then `count` times `unit`, then `tail`.
static char *repeated(const char *head, const char *unit, size_t count, const char *tail)
{
    size_t length = strlen(unit);
    char *text = memory(1, strlen(head) + count * length + strlen(tail) + 1), *at = text + sprintf(text, "%s", head);
    for (size_t i = 0; i < count; i++, at += length)
        memcpy(at, unit, length);
    strcpy(at, tail);
    return text;
}

static void assert_text_refused(const char *text, const char *expected)
{
    assert_true(is_refused(scene_load_text(text, strlen(text), "made.yaml", NULL, &said), "made.yaml", expected));
}

TEST(test_no_file)
{
    assert_true(scene_refused(temporary_path("missing.yaml"), "missing.yaml: cannot be read: No such file"));
    assert_true(scene_refused(temporary, ": is a directory; expected a file"));
    assert_int_equal(mkfifo(temporary_path("pipe.yaml"), 0600), 0);
    assert_true(scene_refused(temporary_path("pipe.yaml"), "pipe.yaml: is not a regular file; expected a file"));
    unlink(temporary_path("pipe.yaml"));
}

TEST(test_unreadable)
{
    if (geteuid() == 0)
        skip(); // root reads everything
    write_text(temporary_path("secret.yaml"), CAMERA LIGHT);
    chmod(temporary_path("secret.yaml"), 0);
    assert_true(scene_refused(temporary_path("secret.yaml"), "secret.yaml: Permission denied"));
    unlink(temporary_path("secret.yaml"));
}

TEST(test_size)
{
    const struct {
        const char *name, *expected;
        off_t size;
    } files[] = {
        {"empty.yaml", "empty.yaml:1:1: the file is empty", 0},
        {"huge.yaml", "huge.yaml: is 5000000 bytes long; expected at most 4194304", 5000000},
        {"huge.obj", "huge.obj: is 600000000 bytes long; expected at most 536870912", 600000000},
    };
    for (int i = 0; i < 3; i++) {
        const char *path = temporary_path(files[i].name);
        write_text(path, "");
        assert_int_equal(truncate(path, files[i].size), 0);
        assert_true(ends_with(path, ".obj") ? mesh_refused("", path, files[i].expected)
                                            : scene_refused(path, files[i].expected));
        unlink(path);
    }
}

TEST(test_depth)
{
    assert_text_refused(repeated("camera: ", "[", 1000000, ""), "made.yaml:1:9: camera is a list");
    assert_text_refused(repeated("camera:\n  position: ", "[", 1000000, ""),
                        "made.yaml:2:14: camera.position[0] is a list");
    assert_text_refused(repeated("", "{camera: ", 300000, ""), "made.yaml:1:11: unknown key 'camera'");
    assert_text_refused(repeated("camera: {position: [", "1, ", 1000000, "1]}"),
                        "made.yaml:1:20: camera.position has 1000001 numbers");
    assert_text_refused(repeated("", "x", 1000000, ": 1"), "made.yaml:1:");
}

TEST(test_too_many)
{
    assert_text_refused(repeated(CAMERA LIGHT "materials:\n", "  - {name: m, type: mirror}\n", 256, ""),
                        "made.yaml:260:5: materials has too many entries; expected at most 255");
    // Every light with a surface takes a material too.
    const char *light = "  - {type: sphere, centre: [0, 0, 0], radius: 1, power: [1, 1, 1]}\n";
    assert_text_refused(repeated(CAMERA "lights:\n", light, 256, ""), "made.yaml:258:5: too many materials");
}
