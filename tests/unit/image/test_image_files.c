// Image files byte by byte: the kinds of PNG and PFM that are read, and damaged ones with what is said about them.
#include "image/codec.h"

#include "unit/image/png_builder.h"
#include "unit/test.h"

// ---- PNG files that are right ----

typedef struct {
    const char *what;
    unsigned char rest[5]; // depth, colour type (0 grey, 2 RGB, 3 palette, +4 alpha), 0, 0, interlace
    size_t size;
    const char *rows; // of 3×2 pixels
} PngKind;

// Encoded values of the pixel in column 1, row 1 are always (0x55, 0xff, 0x00) or, in grey, 0x55.
static const PngKind KINDS[] = {
    {"grey, 2 bits", {2, 0, 0, 0, 0}, 4, "\0\xff\0\x10"},
    {"grey, 4 bits", {4, 0, 0, 0, 0}, 6, "\0\1\2\0\x05\0"},
    {"grey, 8 bits", {8, 0, 0, 0, 0}, 8, "\0\1\2\3\0\1\x55\3"},
    {"grey, 8 bits, filter Up", {8, 0, 0, 0, 0}, 8, "\0\1\x50\3\2\1\x05\3"},
    {"grey, 16 bits", {16, 0, 0, 0, 0}, 14, "\0\1\1\2\2\3\3\0\4\4\x55\x55\6\6"},
    {"grey with alpha", {8, 4, 0, 0, 0}, 14, "\0\1\1\2\2\3\3\0\4\4\x55\0\6\6"},
    {"RGB", {8, 2, 0, 0, 0}, 20, "\0\1\2\3\4\5\6\7\x08\x09\0\1\2\3\x55\xff\0\7\x08\x09"},
    {"RGB with alpha", {8, 6, 0, 0, 0}, 26, "\0aaaabbbbcccc\0aaaa\x55\xff\0\0cccc"},
    {"RGB with alpha, 16 bits",
     {16, 6, 0, 0, 0},
     50,
     "\0aaaaaaaabbbbbbbbcccccccc\0aaaaaaaa\x55\x55\xff\xff\0\0\0\0cccccccc"},
    {"palette, 8 bits", {8, 3, 0, 0, 0}, 8, "\0\0\0\0\0\0\1\0"},
    {"palette, 1 bit", {1, 3, 0, 0, 0}, 4, "\0\0\0\x40"},
    // Passes of 3×2 pixels: (0,0); (2,0); (1,0); row 1.
    {"grey, interlaced", {8, 0, 0, 0, 1}, 10, "\0\1\0\3\0\2\0\1\x55\3"},
    {"RGB, interlaced", {8, 2, 0, 0, 1}, 22, "\0\1\1\1\0\3\3\3\0\2\2\2\0\1\1\1\x55\xff\0\3\3\3"},
};

TEST(every_kind_of_png_is_read)
{
    for (size_t i = 0; i < sizeof KINDS / sizeof *KINDS; i++) {
        const PngKind *kind = &KINDS[i];
        PngFile file;
        Image image;
        png_signature(&file);
        png_header(&file, 3, 2, kind->rest);
        png_chunk(&file, "gAMA", "\0\0\0\1", 4); // not looked at
        if (kind->rest[1] == 3) {
            png_chunk(&file, "PLTE", "\1\2\3\x55\xff\0", 6);
            png_chunk(&file, "tRNS", "\0\0", 2); // transparent, which is dropped
        }
        png_data(&file, kind->rows, kind->size);
        png_end(&file);
        png_put(&file, "what follows the end is not looked at", 37);
        assert_works(image_read_png_memory(&image, file.bytes, file.size, kind->what, &said));
        bool grey = kind->rest[1] == 0 || kind->rest[1] == 4;
        Colour found = *image_at(&image, 1, 1);
        assert_int_equal(image.width, 3);
        assert_int_equal(image.height, 2);
        assert_float_equal(found.r, srgb_decode(1.0f / 3.0f), 1e-7f);
        assert_float_equal(found.g, grey ? found.r : 1.0f, 0.0f);
        assert_float_equal(found.b, grey ? found.r : 0.0f, 0.0f);
        image_free(&image);
    }
}

// ---- PNG files that are damaged ----

// A grey image of 8 bits and 2×2 pixels, with something wrong: what we look at ourselves, and of what libpng finds one of each sort
// (make fuzz READER=png tries the rest). Bytes: header at 8…32, data at 33…61, end at 62…73.
typedef struct {
    uint32_t width, height;
    unsigned char rest[5];
    size_t cut;  // so many bytes are missing at the end
    size_t flip; // this byte is changed; 0: none
    size_t size;
    const char *rows;
    bool no_data;
    const char *message;
} BadPng;

#define GREY {8, 0, 0, 0, 0}
#define ROWS 6, "\0\1\2\0\3\4"

static const BadPng BAD_PNG[] = {
    {2, 2, GREY, 74, 0, ROWS, false, "not a PNG file"},
    {2, 2, GREY, 67, 0, ROWS, false, "not a PNG file"},
    {2, 2, GREY, 0, 3, ROWS, false, "not a PNG file"},
    {2, 2, GREY, 66, 0, ROWS, false, "the file ends too early"},
    {2, 2, GREY, 50, 0, ROWS, false, "the file ends too early"},
    {2, 2, GREY, 1, 0, ROWS, false, "the file ends too early"},
    {2, 2, GREY, 0, 19, ROWS, false, "IHDR: CRC error"},
    {2, 2, GREY, 0, 60, ROWS, false, "IDAT: CRC error"},
    {2, 2, GREY, 0, 33, ROWS, false, "PNG: "}, // a chunk too long; in words that differ by version of libpng
    {0, 2, GREY, 0, 0, ROWS, false, "width is zero"},
    {2, 0, GREY, 0, 0, ROWS, false, "height is zero"},
    {65537, 1, GREY, 0, 0, ROWS, false, "65537×1 pixels; expected 1 to 65536"},
    {1, 0x7fffffff, GREY, 0, 0, ROWS, false, "1×2147483647 pixels"},
    {0x80000000, 1, GREY, 0, 0, ROWS, false, "out of range"},
    {65536, 65536, GREY, 0, 0, ROWS, false, "expected at most 268435456 in all"},
    {65536, 4096, GREY, 0, 0, ROWS, false, "too short for its number of pixels"},
    {2, 2, {3, 0, 0, 0, 0}, 0, 0, ROWS, false, "Invalid bit depth"},
    {2, 2, GREY, 0, 0, ROWS, true, "IEND"},
    {2, 2, GREY, 0, 0, 3, "\0\1\2", false, "Not enough image data"},
};

static void build_bad(PngFile *file, const BadPng *bad)
{
    png_signature(file);
    png_header(file, bad->width, bad->height, bad->rest);
    if (!bad->no_data)
        png_data(file, bad->rows, bad->size);
    png_end(file);
    file->size -= bad->cut;
    if (bad->flip)
        file->bytes[bad->flip] ^= 0x40;
}

static void assert_bad(ImageDecoder *decode, const unsigned char *bytes, size_t size, size_t number,
                       const char *message)
{
    Image image = {9, 9, NULL};
    if (decode(&image, bytes, size, "bad", &said))
        fail_msg("number %zu is read; expected \"%s\"", number, message);
    if (strncmp(said.message, "bad:", 4) != 0 || !strstr(said.message, message))
        fail_msg("number %zu: \"%s\" does not say \"%s\"", number, said.message, message);
    said = (Error){""};
    assert_null(image.pixels);
    assert_int_equal(image.width, 0);
}

TEST(damaged_png_is_refused)
{
    for (size_t i = 0; i < sizeof BAD_PNG / sizeof *BAD_PNG; i++) {
        PngFile file;
        build_bad(&file, &BAD_PNG[i]);
        assert_bad(image_read_png_memory, file.bytes, file.size, i, BAD_PNG[i].message);
    }
}

// ---- PFM ----

#define BYTES(text) (const unsigned char *)(text), sizeof(text) - 1

// 1×2 pixels: the upper one 1 and 2 and -0.5, the lower one 0.
TEST(both_byte_orders_and_grey_are_read)
{
    const struct {
        const unsigned char *bytes;
        size_t size;
        Colour top;
    } cases[] = {
        {BYTES("PF\n1 2\n-1.0\n\0\0\0\0\0\0\0\0\0\0\0\0\0\0\x80\x3f\0\0\0\x40\0\0\0\xbf"), {1, 2, -0.5f}},
        {BYTES("PF\n1 2\n1\n\0\0\0\0\0\0\0\0\0\0\0\0\x3f\x80\0\0\x40\0\0\0\xbf\0\0\0"), {1, 2, -0.5f}},
        {BYTES("Pf\n1 2\n-25e3\n\0\0\0\0\0\0\0\x40"), {2, 2, 2}},
        {BYTES("Pf 1\t2\r\n+.5E-7 \0\0\0\0\x40\0\0\0"), {2, 2, 2}},
    };
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        Image image;
        assert_true(image_read_pfm_memory(&image, cases[i].bytes, cases[i].size, "good", NULL));
        assert_memory_equal(image_at(&image, 0, 0), &cases[i].top, sizeof(Colour));
        assert_true(colour_max(*image_at(&image, 0, 1)) == 0.0f);
        image_free(&image);
    }
}

static const struct {
    const unsigned char *bytes;
    size_t size;
    const char *message;
} BAD_PFM[] = {
    {BYTES(""), "bad:1: the file ends; expected \"PF\""},
    {BYTES("P6\n1 1\n255\nabc"), "bad:1: found \"P6\"; expected \"PF\""},
    {BYTES("PF4\n1 1\n-1\n"), "bad:1: found \"PF4\""},
    {BYTES("\x89PNG\r\n\x1a\n"), "bad:1: found \"?PNG\""},
    {BYTES("PF\n"), "bad:2: the file ends; expected the width"},
    {BYTES("PF\n3"), "bad:2: the file ends; expected the height"},
    {BYTES("PF\n3 2\n"), "bad:3: the file ends; expected the scale"},
    {BYTES("PF\nwide 2\n-1\n"), "bad:2: found \"wide\"; expected the width"},
    {BYTES("PF\n-1 2\n-1\n"), "bad:2: found \"-1\"; expected the width"},
    {BYTES("PF\n2.5 2\n-1\n"), "bad:2: found \"2.5\""},
    {BYTES("PF\n2 0\n-1\n"), "bad:2: found \"0\"; expected the height"},
    {BYTES("PF\n65537 1\n-1\n"), "bad:2: found \"65537\""},
    {BYTES("PF\n1 99999999999999999999\n-1\n"), "bad:2: found \"99999999999999999999\""},
    {BYTES("PF\n65536 65536\n-1\n"), "bad: the size is 65536×65536 pixels; expected at most 268435456"},
    {BYTES("PF\n65536 4096\n-1\n"), "bad: truncated: 0 bytes of pixels; expected 3221225472"},
    {BYTES("PF\n1\n\n1 nan\n"), "bad:4: found \"nan\"; expected the scale"},
    {BYTES("PF\n1 1\n-0.0e5\n"), "bad:3: found \"-0.0e5\""},
    {BYTES("PF\n1 1\n-1.0.0\n"), "bad:3: found \"-1.0.0\""},
    {BYTES("PF\n1 1\n-1e\n"), "bad:3: found \"-1e\""},
    {BYTES("PF\n1 1\n--1\n"), "bad:3: found \"--1\""},
    {BYTES("PF\n1 1\n1,0\n"), "bad:3: found \"1,0\""},
    {BYTES("PF\n1 1\n1.00000000000000000000000000000000000001\n"), "bad:3: found \"1.0000"},
    {BYTES("Pf\n1 1\n-1"), "truncated: 0 bytes of pixels; expected 4"},
    {BYTES("Pf\n1 1\n-1\n\0\0\0"), "truncated: 3 bytes of pixels; expected 4"},
    {BYTES("PF\n1 1\n-1\n\0\0\0\0"), "truncated: 4 bytes of pixels; expected 12"},
    {BYTES("Pf\n1 1\n-1\n\0\0\0\0\n"), "1 bytes too many"},
    {BYTES("Pf\n2 1\n-1\n\0\0\0\0\0\0\xc0\x7f"), "column 1, row 0"},
    {BYTES("Pf\n1 2\n1\n\x7f\xc0\0\0\0\0\0\0"), "column 0, row 1"},
    {BYTES("Pf\n1 1\n1\n\x7f\x80\0\0"), "(inf, inf, inf)"},
    {BYTES("PF\n1 1\n1\n\0\0\0\0\xff\x80\0\0\0\0\0\0"), "(0, -inf, 0)"},
};

TEST(damaged_pfm_is_refused)
{
    for (size_t i = 0; i < sizeof BAD_PFM / sizeof *BAD_PFM; i++)
        assert_bad(image_read_pfm_memory, BAD_PFM[i].bytes, BAD_PFM[i].size, i, BAD_PFM[i].message);
}
