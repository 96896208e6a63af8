// Across an edge: 5_profile MM DATA NUMBERS STRIP …
// Strips that are MM millimetres wide, dark at the left. DATA: place, mm from the middle, then for each strip the mean over its rows,
// green. NUMBERS: for strip i, `rise_i` the way in mm from a fifth to four fifths of what lies
// between the dark and the peak, and `peak_i`.
#include "photonlab.h"

#include <stdio.h>
#include <stdlib.h>

enum { MOST = 6, WIDEST = 1024 };

static double columns[MOST][WIDEST];

static int read_columns(const char *path, double *column)
{
    Error error = {""};
    Image image;
    if (!image_read(&image, path, &error) || image.width > WIDEST) {
        fprintf(stderr, "5_profile: %s\n", error.message[0] ? error.message : "too wide");
        exit(1);
    }
    for (int y = 0; y < image.height; y++)
        for (int x = 0; x < image.width; x++)
            column[x] += (double)image_at(&image, x, y)->g / image.height;
    int width = image.width;
    image_free(&image);
    return width;
}

static double highest(const double *column, int width)
{
    double peak = 0.0;
    for (int x = 0; x < width; x++)
        peak = fmax(peak, column[x]);
    return peak;
}

// Where it first has risen to this share, in columns.
static double crossing(const double *column, int width, double share)
{
    double dark = 0.0;
    for (int x = 0; x < width / 8; x++)
        dark += column[x] / (width / 8);
    double level = dark + share * (highest(column, width) - dark);
    int x = 0;
    while (column[x] < level)
        x++;
    return x > 0 ? x - (column[x] - level) / (column[x] - column[x - 1]) : 0.0;
}

int main(int count, char **arguments)
{
    FILE *data = count > 4 ? fopen(arguments[2], "w") : NULL, *numbers = count > 4 ? fopen(arguments[3], "w") : NULL;
    if (!data || !numbers || count > 4 + MOST)
        return fprintf(stderr, "usage: 5_profile MM DATA NUMBERS STRIP …\n"), 2;
    int width = 0, strips = count - 4;
    for (int i = 0; i < strips; i++) {
        width = read_columns(arguments[4 + i], columns[i]);
        double way = crossing(columns[i], width, 0.8) - crossing(columns[i], width, 0.2);
        fprintf(numbers, "rise_%d %.2f\npeak_%d %.2f\n", i + 1, way * atof(arguments[1]) / width, i + 1,
                highest(columns[i], width));
    }
    for (int x = 0; x < width; x++) {
        fprintf(data, "%.3f", ((x + 0.5) / width - 0.5) * atof(arguments[1]));
        for (int i = 0; i < strips; i++)
            fprintf(data, " %.5g", columns[i][x]);
        fprintf(data, "\n");
    }
    return fclose(data) == 0 && fclose(numbers) == 0 ? 0 : 1;
}
