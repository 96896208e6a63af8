// Images: the sRGB curve, files that are written and read again, writes that fail, differences worked out by hand.
#include "unit/image/image_helpers.h"
#include "base/file.h"
#include "image/codec.h"

#include <dirent.h>
#include <float.h>
#include <signal.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

static char folder[] = "/tmp/photonlab-image-XXXXXX";

// ---- Helpers ----

FIXTURE(enter_folder)
{
    return mkdtemp(folder) && chdir(folder) == 0 ? 0 : -1;
}

// Counts what is in the folder; removes it too if asked.
static int count_files(bool empty)
{
    int count = 0;
    DIR *directory = opendir(".");
    assert_non_null(directory);
    for (struct dirent *entry; (entry = readdir(directory));)
        if (entry->d_name[0] != '.') {
            count++;
            if (empty)
                remove(entry->d_name);
        }
    closedir(directory);
    return count;
}

FIXTURE(leave_folder)
{
    count_files(true);
    return chdir("/") == 0 && rmdir(folder) == 0 ? 0 : -1;
}

// Values from 0 to 1 which no two neighbours share.
static Image make_pattern(int width, int height)
{
    Image image = make_image(width, height);
    for (int i = 0; i < width * height; i++)
        image.pixels[i] =
            colour((float)(i * 37 % 101) / 100.0f, (float)(i * 53 % 97) / 96.0f, (float)(i * 71 % 89) / 8800.0f);
    return image;
}

// ---- Curve and memory ----

TEST(curve_has_known_values)
{
    assert_float_equal(srgb_encode(0.5f), 0.735357f, 1e-6f);
    assert_float_equal(srgb_encode(0.18f), 0.461356f, 1e-6f);
    assert_float_equal(srgb_encode(0.002f), 0.02584f, 1e-7f);
    assert_float_equal(srgb_decode(0.5f), 0.214041f, 1e-6f);
    assert_float_equal(srgb_decode(0.02584f), 0.002f, 1e-8f);
    const float clipped[][2] = {{0, 0}, {-1, 0}, {1, 1}, {2, 1}, {INFINITY, 1}, {-INFINITY, 0}, {NAN, 0}};
    for (size_t i = 0; i < sizeof clipped / sizeof *clipped; i++) {
        assert_true(srgb_encode(clipped[i][0]) == clipped[i][1]);
        assert_true(srgb_decode(clipped[i][0]) == clipped[i][1]);
    }
}

TEST(curve_and_back_keeps_16_bits)
{
    for (int i = 0; i <= 65535; i++) {
        float again = srgb_encode(srgb_decode((float)i / 65535.0f));
        assert_int_equal((int)(again * 65535.0f + 0.5f), i);
    }
}

TEST(create_refuses_impossible_sizes)
{
    const int sizes[][2] = {{0, 1}, {1, 0}, {-3, 5}, {65537, 1}, {1, 65537}, {65536, 65536}};
    for (size_t i = 0; i < sizeof sizes / sizeof *sizes; i++) {
        Image image = {7, 7, NULL};
        assert_refused(image_create(&image, sizes[i][0], sizes[i][1], &said), "the size is");
        assert_null(image.pixels);
        image_free(&image);
    }
    Image image;
    assert_true(image_create(&image, IMAGE_MAX_SIDE, 1, NULL));
    assert_true(image_at(&image, IMAGE_MAX_SIDE - 1, 0)->b == 0.0f);
    image_free(&image);
    image_free(&image);
}

// ---- Files ----

static const int sizes[][2] = {{1, 1}, {1, 7}, {9, 1}, {5, 3}, {64, 33}};
#define SIZES (sizeof sizes / sizeof *sizes)

// Without OpenEXR, EXR is refused as a name.
TEST(pfm_and_exr_come_back_exactly)
{
    bool has_exr = !image_format_exr.missing;
    for (size_t i = 0; i < SIZES * (has_exr ? 2 : 1); i++) {
        const char *name = i < SIZES ? "exact.PFM" : "exact.Exr";
        Image image = make_pattern(sizes[i % SIZES][0], sizes[i % SIZES][1]);
        image.pixels[0] = colour(-FLT_MAX, 1e-42f, -0.0f);
        assert_true(image_write_bits(&image, name, 16, NULL));
        Image again = image_of_file(name);
        assert_int_equal(again.width, image.width);
        assert_int_equal(again.height, image.height);
        assert_memory_equal(again.pixels, image.pixels, sizeof(Colour) * (size_t)image.width * (size_t)image.height);
    }
}

// Cut off anywhere, or with a byte of the first 2000 spoilt: an error or a picture, and nothing left of one that failed.
TEST(damaged_exr_is_refused)
{
    Image image = make_pattern(33, 40), again;
    if (!image_write(&image, "damaged.exr", &said)) {
        assert_said("damaged.exr: no .exr files here: built without OpenEXR");
        return;
    }
    size_t size;
    char *bytes = file_read("damaged.exr", 100000, &size, &said);
    assert_non_null(bytes);
    at_end(free, bytes);
    for (size_t i = 0; i < size; i += 7) {
        assert_refused(image_format_exr.decode(&again, (unsigned char *)bytes, i, "cut.exr", &said), "cut.exr: EXR: ");
        assert_null(again.pixels);
    }
    for (size_t i = 0; i < 2000 && i < size; i++) {
        bytes[i] = (char)(bytes[i] ^ (1 << i % 8));
        if (image_format_exr.decode(&again, (unsigned char *)bytes, size, "spoilt.exr", &said))
            image_free(&again);
        bytes[i] = (char)(bytes[i] ^ (1 << i % 8));
    }
}

TEST(png_comes_back_within_half_a_step)
{
    for (size_t i = 0; i < 2 * SIZES; i++) {
        int bits = i % 2 ? 8 : 16;
        float step = bits == 8 ? 1.0f / 255.0f : 1.0f / 65535.0f;
        Image image = make_pattern(sizes[i / 2][0], sizes[i / 2][1]);
        image.pixels[0] = colour(-1.0f, 1e30f, 0.5f);
        assert_true(image_write_png(&image, "near.png", bits, NULL));
        Image again = image_of_file("near.png");
        assert_int_equal(again.width, image.width);
        assert_int_equal(again.height, image.height);
        for (int p = 0; p < image.width * image.height; p++)
            for (int c = 0; c < 3; c++)
                assert_float_equal(srgb_encode(colour_channel(again.pixels[p], c)),
                                   srgb_encode(colour_channel(image.pixels[p], c)), 0.5f * step + 1e-6f);
    }
}

TEST(endings_choose_the_format)
{
    const char *known[] = {"a.png", "a.PNG", "b.c/d.Pfm"}, *unknown[] = {"a.jpg", "png", "a.png/b", "", "a."};
    for (size_t i = 0; i < 3; i++)
        assert_true(image_path_is_known(known[i], NULL));
    Image image = make_image(1, 1), none;
    for (size_t i = 0; i < 5; i++) {
        assert_refused(image_path_is_known(unknown[i], &said), i == 0   ? "ends in .jpg; expected .png"
                                                               : i == 4 ? "ends in .;"
                                                                        : "no ending");
        assert_false(image_write(&image, unknown[i], NULL));
        assert_false(image_read(&none, unknown[i], NULL));
    }
}

TEST(paths_that_cannot_be_used_are_named)
{
    Image image = make_image(1, 1), none = {0};
    assert_int_equal(mkdir("folder.png", 0777), 0);
    assert_refused(image_read(&none, "missing.png", &said), "missing.png: cannot be read: No such file");
    assert_refused(image_write(&image, "nowhere/a.pfm", &said), "nowhere/a.pfm: cannot be written: No such file");
    assert_refused(image_read(&none, "folder.png", &said), "folder.png: is a directory");
    assert_refused(image_write(&image, "folder.png", &said), "folder.png: is a directory");
    assert_refused(image_write_pfm(&image, "/dev/null", &said), "/dev/null: is not a regular file");
    assert_refused(image_write_png(&image, "a.png", 12, &said), "expected 8 or 16");
    assert_false(image_write_png(&none, "a.png", 8, NULL));
    rmdir("folder.png");
}

TEST(failed_writes_keep_the_old_file)
{
    const char *paths[] = {"keep.png", "keep.pfm"};
    const float bad[] = {NAN, INFINITY, -INFINITY};
    Image old = make_pattern(5, 4), large = make_pattern(64, 64);
    for (int i = 0; i < 2; i++) {
        count_files(true);
        assert_true(image_write(&old, paths[i], NULL));
        for (int b = 0; b < 3; b++) {
            Image image = make_pattern(6, 4);
            image_at(&image, 3, 2)->g = bad[b];
            assert_refused(image_write(&image, paths[i], &said), "column 3, row 2");
        }
        // A limit on the length of files stands for the full disk. It hits everything, so it goes before the checks.
        struct rlimit limit, small;
        signal(SIGXFSZ, SIG_IGN);
        getrlimit(RLIMIT_FSIZE, &limit);
        small = limit;
        small.rlim_cur = 1000;
        setrlimit(RLIMIT_FSIZE, &small);
        bool written = image_write(&large, paths[i], &said);
        setrlimit(RLIMIT_FSIZE, &limit);
        assert_false(written);
        assert_said("File too large");
        assert_int_equal(count_files(false), 1);
        assert_int_equal(image_of_file(paths[i]).width, 5);
        assert_true(image_write(&large, paths[i], NULL));
        assert_int_equal(count_files(false), 1);
        assert_int_equal(image_of_file(paths[i]).width, 64);
    }
}

TEST(protected_places_are_refused)
{
    if (geteuid() == 0)
        skip(); // the administrator may write anywhere
    Image image = make_image(1, 1);
    assert_true(image_write(&image, "protected.png", NULL));
    assert_int_equal(chmod("protected.png", 0444), 0);
    assert_refused(image_write(&image, "protected.png", &said), "protected.png: cannot be written: Permission denied");
    assert_int_equal(chmod(".", 0555), 0);
    bool written = image_write(&image, "new.png", &said);
    assert_int_equal(chmod(".", 0777), 0);
    assert_false(written);
    assert_said("new.png: cannot be written: Permission denied");
}

AROUND_TESTS(enter_folder, leave_folder)
