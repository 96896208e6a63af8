#include "cli/cli.h"

#include <stdio.h>

static const char help[] =
    "usage: photonlab diff IMAGE REFERENCE [-o DIFFERENCE.png] [flags]\n"
    "\n"
    "Compares two pictures (.pfm, .exr or .png) of one size. Prints, per channel: RMSE; relMSE, the mean of (x−r)²/(r²+0.01); the\n"
    "ratio of the means. `trimmed` leaves out the worst 0.1 % of pixels.\n"
    "\n"
    "  -o FILE              also draw image − reference: red brighter, blue darker, white the same\n"
    "  --scale S            the difference that gets full colour; 0 chooses (default)\n"
    "  --mask X0,Y0,X1,Y1   leave out columns X0 ≤ x < X1, rows Y0 ≤ y < Y1 (a visible light, say)\n"
    "  --blocks N           compare means over N×N pixels: blotches, not grain; a picture N times smaller has them for pixels\n"
    "  --json               one line of JSON instead\n";

static const char *files[2]; // picture and reference
static const char *out, *mask_text;
static float scale;
static int blocks;
static bool json;
static const Flag flags[] = {
    {"o", FLAG_TEXT, &out, 0, 0},          {"scale", FLAG_FLOAT, &scale, 0, SCENE_LARGEST_NUMBER},
    {"mask", FLAG_TEXT, &mask_text, 0, 0}, {"blocks", FLAG_INT, &blocks, 1, MOST_SIDE},
    {"json", FLAG_PRESENT, &json, 0, 0},
};

static void print_json(const ImageDifference *d)
{
    printf("{\"rmse\":[%.9g,%.9g,%.9g],\"relmse\":[%.9g,%.9g,%.9g],\"mean_ratio\":[%.9g,%.9g,%.9g],"
           "\"relmse_all\":%.9g,\"relmse_trimmed\":%.9g,\"pixels\":%zu}\n",
           d->rmse[0], d->rmse[1], d->rmse[2], d->relative_mse[0], d->relative_mse[1], d->relative_mse[2],
           d->mean_ratio[0], d->mean_ratio[1], d->mean_ratio[2], d->relative_mse_all, d->relative_mse_trimmed,
           d->pixels);
}

static void print_table(const ImageDifference *d)
{
    static const char *const names[] = {"red", "green", "blue"};
    printf("         RMSE        relMSE      mean ratio\n");
    for (int c = 0; c < 3; c++)
        printf("%-8s %-11.4g %-11.4g %.5f\n", names[c], d->rmse[c], d->relative_mse[c], d->mean_ratio[c]);
    printf("relMSE %.4g, trimmed %.4g (%zu pixels)\n", d->relative_mse_all, d->relative_mse_trimmed, d->pixels);
}

// The picture in blocks takes its place.
static bool shrink(Image *image, int side, ImageMask mask, Error *error)
{
    Image means = {0, 0, NULL};
    bool ok = image_blocks(image, side, mask, &means, error);
    image_free(image);
    *image = means;
    return ok;
}

// A picture that is as large as the reference in blocks has them for pixels.
static bool shrink_both(Image *image, Image *reference, ImageMask mask, Error *error)
{
    bool shrunk = image->width * blocks == reference->width && image->height * blocks == reference->height;
    int side = shrunk ? blocks : 1;
    ImageMask own = {mask.x0 / side, mask.y0 / side, mask.x1 / side, mask.y1 / side};
    return shrink(image, blocks / side, own, error) && shrink(reference, blocks, mask, error);
}

static bool compare(Image *image, Image *reference, ImageMask mask, Image *picture, Error *error)
{
    ImageDifference difference;
    if (!image_read(image, files[0], error) || !image_read(reference, files[1], error) ||
        (blocks && !shrink_both(image, reference, mask, error)) ||
        !image_difference(image, reference, blocks ? (ImageMask){0, 0, 0, 0} : mask, &difference, error))
        return false;
    if (out &&
        (!image_difference_picture(image, reference, scale, picture, error) || !image_write(picture, out, error)))
        return false;
    if (json)
        print_json(&difference);
    else
        print_table(&difference);
    return true;
}

static int run(void)
{
    Error error = {""};
    Image image = {0, 0, NULL}, reference = {0, 0, NULL}, picture = {0, 0, NULL};
    ImageMask mask = {0, 0, 0, 0};
    char after;
    if (mask_text && sscanf(mask_text, "%d,%d,%d,%d%c", &mask.x0, &mask.y0, &mask.x1, &mask.y1, &after) != 4)
        return report_usage("photonlab diff", "--mask %s: expected four whole numbers X0,Y0,X1,Y1", mask_text);
    if (out && !image_path_is_known(out, &error))
        return report_usage("photonlab diff", "%s", error.message);
    bool ok = compare(&image, &reference, mask, &picture, &error);
    image_free(&image);
    image_free(&reference);
    image_free(&picture);
    return ok ? 0 : report_error(&error);
}

const Command command_diff = {
    .words = "compare two pictures",
    .line = {"photonlab diff", help, "two pictures", flags, FLAG_COUNT(flags), 2, 2},
    .files = files,
    .run = run,
};
