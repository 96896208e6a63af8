// The difference of two images, against values worked out by hand.
#include "unit/image/image_helpers.h"

static const ImageMask NO_MASK = {0, 0, 0, 0};

static Image difference_of(const Image *image, const Image *reference, float scale)
{
    Image picture;
    assert_works(image_difference_picture(image, reference, scale, &picture, &said));
    return *own_image(kept(&picture, sizeof picture));
}

static void assert_exact(double value, double expected)
{
    if (!(fabs(value - expected) <= 1e-12 * fabs(expected)))
        fail_msg("%.17g is not %.17g", value, expected);
}

// Image (2, 0, 2), (3, 0, 0) against reference (1, 0, 2), (3, 0, 2).
TEST(two_pixels_have_known_values)
{
    Image image = make_image(2, 1), reference = make_image(2, 1);
    ImageDifference d;
    image.pixels[0] = colour(2, 0, 2);
    image.pixels[1] = colour(3, 0, 0);
    reference.pixels[0] = colour(1, 0, 2);
    reference.pixels[1] = colour(3, 0, 2);
    assert_true(image_difference(&image, &reference, NO_MASK, &d, NULL));
    assert_int_equal(d.pixels, 2);
    assert_exact(d.rmse[0], sqrt(1.0 / 2.0));
    assert_exact(d.rmse[1], 0.0);
    assert_exact(d.rmse[2], sqrt(4.0 / 2.0));
    assert_exact(d.relative_mse[0], 1.0 / 1.01 / 2.0);
    assert_exact(d.relative_mse[1], 0.0);
    assert_exact(d.relative_mse[2], 4.0 / 4.01 / 2.0);
    assert_exact(d.relative_mse_all, (1.0 / 1.01 + 4.0 / 4.01) / 6.0);
    assert_exact(d.relative_mse_trimmed, d.relative_mse_all);
    assert_exact(d.mean_ratio[0], 5.0 / 4.0);
    assert_exact(d.mean_ratio[1], 1.0);
    assert_exact(d.mean_ratio[2], 2.0 / 4.0);
    image.pixels[0].g = 0.5f;
    assert_true(image_difference(&image, &reference, NO_MASK, &d, NULL));
    assert_true(isinf(d.mean_ratio[1]) && d.mean_ratio[1] > 0.0);
}

TEST(mask_leaves_its_rectangle_out)
{
    Image image = make_image(5, 4), reference = make_image(5, 4);
    ImageDifference d;
    image_at(&image, 1, 2)->r = 1.0f;
    image_at(&image, 2, 3)->r = 1.0f;
    assert_true(image_difference(&image, &reference, (ImageMask){1, 2, 3, 4}, &d, NULL));
    assert_int_equal(d.pixels, 16);
    assert_true(d.relative_mse_all == 0.0);
    const ImageMask one_short[] = {{2, 2, 3, 4}, {1, 3, 3, 4}, {1, 2, 2, 4}, {1, 2, 3, 3}};
    for (int i = 0; i < 4; i++) {
        assert_true(image_difference(&image, &reference, one_short[i], &d, NULL));
        assert_int_equal(d.pixels, 18);
        assert_exact(d.relative_mse[0], 1.0 / 0.01 / 18.0);
    }
    const ImageMask nothing[] = {{3, 2, 3, 4}, {4, 3, 1, 0}, {9, 9, 12, 12}, {-5, -5, 0, 9}};
    for (int i = 0; i < 4; i++) {
        assert_true(image_difference(&image, &reference, nothing[i], &d, NULL));
        assert_int_equal(d.pixels, 20);
    }
    assert_refused(image_difference(&image, &reference, (ImageMask){-1, -1, 9, 9}, &d, &said), "nothing to compare");
}

TEST(trimming_drops_one_pixel_in_a_thousand)
{
    Image image = make_image(2000, 1), reference = make_image(2000, 1);
    ImageDifference d;
    image.pixels[7].r = 3.0f;
    image.pixels[1999].b = 2.0f;
    assert_true(image_difference(&image, &reference, NO_MASK, &d, NULL));
    assert_exact(d.relative_mse_all, (9.0 + 4.0) / 0.01 / 6000.0);
    assert_true(d.relative_mse_trimmed == 0.0);
    image.pixels[1000] = colour(1.0f, 1.0f, 1.0f); // 3 in all: less than 4 and 9, although in more channels
    assert_true(image_difference(&image, &reference, NO_MASK, &d, NULL));
    assert_exact(d.relative_mse_trimmed, 3.0 / 0.01 / (3.0 * 1998.0));
    assert_true(image_difference(&image, &reference, (ImageMask){999, 0, 2000, 1}, &d, NULL));
    assert_int_equal(d.pixels, 999);
    assert_exact(d.relative_mse_trimmed, 9.0 / 0.01 / (3.0 * 999.0));
}

TEST(pairs_that_cannot_be_compared_are_refused)
{
    Image image = make_image(3, 2), turned = make_image(2, 3), broken = make_image(3, 2), empty = {0}, picture;
    ImageDifference d;
    image_at(&broken, 2, 1)->b = NAN;
    assert_refused(image_difference(&image, &turned, NO_MASK, &d, &said), "the image is 3×2 pixels, the reference 2×3");
    assert_refused(image_difference(&image, &broken, NO_MASK, &d, &said), "reference: the pixel in column 2, row 1");
    assert_false(image_difference(&broken, &image, NO_MASK, &d, NULL));
    assert_false(image_difference(&empty, &empty, NO_MASK, &d, NULL));
    assert_false(image_difference_picture(&image, &turned, 1.0f, &picture, NULL));
    assert_false(image_difference_picture(&image, &broken, 1.0f, &picture, NULL));
    assert_false(image_difference_picture(&image, &image, NAN, &picture, NULL));
    assert_refused(image_difference_picture(&image, &image, -1.0f, &picture, &said), "the scale of the picture is -1");
    assert_null(picture.pixels);
}

static void assert_colour(Colour c, float r, float g, float b)
{
    assert_float_equal(c.r, r, 1e-6f);
    assert_float_equal(c.g, g, 1e-6f);
    assert_float_equal(c.b, b, 1e-6f);
}

TEST(picture_is_red_where_brighter)
{
    Image image = make_image(5, 1), reference = make_image(5, 1);
    image.pixels[0] = colour(0.75f, 0.0f, 0.0f); // the mean over channels: 0.25
    reference.pixels[1] = colour_grey(0.25f);
    image.pixels[2] = colour(1.0f, -1.0f, 0.0f);
    image.pixels[3] = colour_grey(9.0f);
    reference.pixels[4] = colour_grey(9.0f);
    Image picture = difference_of(&image, &reference, 0.5f);
    assert_colour(picture.pixels[0], 1.0f, 0.5f, 0.5f);
    assert_colour(picture.pixels[1], 0.5f, 0.5f, 1.0f);
    assert_colour(picture.pixels[2], 1.0f, 1.0f, 1.0f);
    assert_colour(picture.pixels[3], 1.0f, 0.0f, 0.0f);
    assert_colour(picture.pixels[4], 0.0f, 0.0f, 1.0f);
}

TEST(picture_finds_its_scale)
{
    Image image = make_image(201, 1), reference = make_image(201, 1);
    for (int i = 0; i <= 200; i++)
        image.pixels[(i * 89) % 201] = colour_grey((float)i / 200.0f); // percentile 99: number 198, 0.99
    Image picture = difference_of(&image, &reference, 0.0f);
    assert_colour(picture.pixels[99 * 89 % 201], 1.0f, 0.5f, 0.5f);
    assert_colour(picture.pixels[197 * 89 % 201], 1.0f, 1.0f - 0.985f / 0.99f, 1.0f - 0.985f / 0.99f);
    assert_colour(picture.pixels[200 * 89 % 201], 1.0f, 0.0f, 0.0f);
    picture = difference_of(&image, &image, 0.0f);
    assert_colour(picture.pixels[200], 1.0f, 1.0f, 1.0f);
    memset(image.pixels, 0, 201 * sizeof *image.pixels);
    image.pixels[3] = colour_grey(0.5f); // too few: the percentile is 0, the largest decides
    image.pixels[5] = colour_grey(0.25f);
    picture = difference_of(&reference, &image, 0.0f);
    assert_colour(picture.pixels[3], 0.0f, 0.0f, 1.0f);
    assert_colour(picture.pixels[5], 0.5f, 0.5f, 1.0f);
    assert_colour(picture.pixels[4], 1.0f, 1.0f, 1.0f);
}
