#include "cli/cli.h"

#include <getopt.h>
#include <stdio.h>

static const char help[] =
    "usage: photonlab diff IMAGE REFERENCE [-o DIFFERENCE.png] [flags]\n"
    "\n"
    "Compares two pictures (.pfm or .png) of one size. Prints, per channel: RMSE; relMSE, the mean of "
    "(x−r)²/(r²+0.01); the\n"
    "ratio of the means. `trimmed` leaves out the worst 0.1 % of pixels.\n"
    "\n"
    "  -o FILE              also draw image − reference: red brighter, blue darker, white the same\n"
    "  --scale S            the difference that gets full colour; 0 chooses (default)\n"
    "  --mask X0,Y0,X1,Y1   leave out columns X0 ≤ x < X1, rows Y0 ≤ y < Y1 (a visible light, say)\n"
    "  --json               one line of JSON instead\n";

enum { SCALE = 256, MASK };

static const struct option flags[] = {
    {"scale", required_argument, NULL, SCALE}, {"mask", required_argument, NULL, MASK},
    {"json", no_argument, NULL, 'j'},          {"output", required_argument, NULL, 'o'},
    {"help", no_argument, NULL, 'h'},          {NULL, 0, NULL, 0},
};

typedef struct {
    const char *image, *reference, *out;
    ImageMask mask;
    float scale;
    bool json;
} Arguments;

static bool parse_flag(int flag, Arguments *a)
{
    ImageMask *m = &a->mask;
    char after;
    switch (flag) {
    case 'o':
        a->out = optarg;
        return true;
    case 'j':
        a->json = true;
        return true;
    case SCALE:
        return parse_float("diff", "--scale", optarg, 0.0f, 1e30f, &a->scale);
    case MASK:
        if (sscanf(optarg, "%d,%d,%d,%d%c", &m->x0, &m->y0, &m->x1, &m->y1, &after) == 4)
            return true;
        report_usage("diff", "--mask %s: expected four whole numbers X0,Y0,X1,Y1", optarg);
        return false;
    }
    return false;
}

static int parse(int count, char **arguments, Arguments *a)
{
    *a = (Arguments){NULL, NULL, NULL, {0, 0, 0, 0}, 0.0f, false};
    optind = 1;
    for (int flag; (flag = getopt_long(count, arguments, "o:h", flags, NULL)) != -1;) {
        if (flag == 'h') {
            fputs(help, stdout);
            return -1;
        }
        if (flag == '?')
            return report_usage("diff", "see above");
        if (!parse_flag(flag, a))
            return EXIT_USAGE;
    }
    if (optind + 2 != count)
        return report_usage("diff", "expected two pictures, found %d", count - optind);
    a->image = arguments[optind];
    a->reference = arguments[optind + 1];
    Error error = {""};
    if (a->out && !image_path_is_known(a->out, &error))
        return report_usage("diff", "%s", error.message);
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

static bool compare(const Arguments *a, Image *image, Image *reference, Image *picture, Error *error)
{
    ImageDifference difference;
    if (!image_read(image, a->image, error) || !image_read(reference, a->reference, error) ||
        !image_difference(image, reference, a->mask, &difference, error))
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
        return wrong < 0 ? 0 : wrong;
    Error error = {""};
    Image image = {0, 0, NULL};
    Image reference = {0, 0, NULL};
    Image picture = {0, 0, NULL};
    bool ok = compare(&a, &image, &reference, &picture, &error);
    image_free(&image);
    image_free(&reference);
    image_free(&picture);
    return ok ? 0 : report_error(&error);
}
