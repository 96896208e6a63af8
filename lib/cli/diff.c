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

typedef struct {
    const char *files[2]; // picture and reference
    const char *out;
    ImageMask mask;
    float scale;
    int blocks;
    bool json;
} Arguments;

// 0 when the arguments are right, otherwise the exit code or HELP_SHOWN.
static int parse(int count, char **arguments, Arguments *a)
{
    *a = (Arguments){.out = NULL};
    const char *mask = NULL;
    const Flag flags[] = {
        {"o", FLAG_TEXT, &a->out, 0, 0},        {"scale", FLAG_FLOAT, &a->scale, 0, SCENE_LARGEST_NUMBER},
        {"mask", FLAG_TEXT, &mask, 0, 0},       {"blocks", FLAG_INT, &a->blocks, 1, MOST_SIDE},
        {"json", FLAG_PRESENT, &a->json, 0, 0},
    };
    int wrong =
        command_line_parse(&(CommandLine){"photonlab diff", help, "two pictures", flags, FLAG_COUNT(flags), 2, 2},
                           count, arguments, a->files);
    if (wrong)
        return wrong;
    ImageMask *m = &a->mask;
    char after;
    if (mask && sscanf(mask, "%d,%d,%d,%d%c", &m->x0, &m->y0, &m->x1, &m->y1, &after) != 4)
        return report_usage("photonlab diff", "--mask %s: expected four whole numbers X0,Y0,X1,Y1", mask);
    Error error = {""};
    if (a->out && !image_path_is_known(a->out, &error))
        return report_usage("photonlab diff", "%s", error.message);
    return 0;
}

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
    Image blocks = {0, 0, NULL};
    bool ok = image_blocks(image, side, mask, &blocks, error);
    image_free(image);
    *image = blocks;
    return ok;
}

// A picture that is as large as the reference in blocks has them for pixels.
static bool shrink_both(const Arguments *a, Image *image, Image *reference, Error *error)
{
    int side = a->blocks;
    ImageMask mask = a->mask;
    if (image->width * side == reference->width && image->height * side == reference->height) {
        mask = (ImageMask){mask.x0 / side, mask.y0 / side, mask.x1 / side, mask.y1 / side};
        side = 1;
    }
    return shrink(image, side, mask, error) && shrink(reference, a->blocks, a->mask, error);
}

static bool compare(const Arguments *a, Image *image, Image *reference, Image *picture, Error *error)
{
    ImageDifference difference;
    if (!image_read(image, a->files[0], error) || !image_read(reference, a->files[1], error) ||
        (a->blocks && !shrink_both(a, image, reference, error)) ||
        !image_difference(image, reference, a->blocks ? (ImageMask){0, 0, 0, 0} : a->mask, &difference, error))
        return false;
    if (a->out &&
        (!image_difference_picture(image, reference, a->scale, picture, error) || !image_write(picture, a->out, error)))
        return false;
    if (a->json)
        print_json(&difference);
    else
        print_table(&difference);
    return true;
}

int command_diff(int count, char **arguments)
{
    Arguments a;
    int wrong = parse(count, arguments, &a);
    if (wrong)
        return wrong == HELP_SHOWN ? 0 : wrong;
    Error error = {""};
    Image image = {0, 0, NULL}, reference = {0, 0, NULL}, picture = {0, 0, NULL};
    bool ok = compare(&a, &image, &reference, &picture, &error);
    image_free(&image);
    image_free(&reference);
    image_free(&picture);
    return ok ? 0 : report_error(&error);
}
