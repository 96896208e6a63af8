// How the class's points are spread: quartiles and a histogram. Who handed in nothing, or nothing that could be graded,
// is not in it.
#include "class/table/class_table.h"

#include <stdlib.h>
#include <string.h>

#define BINS 10

static int compare(const void *a, const void *b)
{
    double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

// Between the two values on both sides, where none is exactly there.
static double quantile(const double *sorted, size_t count, double part)
{
    double at = part * (double)(count - 1);
    size_t below = (size_t)at;
    double above = below + 1 < count ? sorted[below + 1] : sorted[below];
    return sorted[below] + (at - (double)below) * (above - sorted[below]);
}

static void write_bins(FILE *stream, const double *points, size_t count, double most)
{
    size_t bins[BINS] = {0}, highest = 1;
    for (size_t i = 0; i < count; i++) {
        size_t bin = most > 0.0 ? (size_t)(points[i] / most * BINS) : 0;
        bins[bin < BINS ? bin : BINS - 1]++;
    }
    for (size_t i = 0; i < BINS; i++)
        highest = bins[i] > highest ? bins[i] : highest;
    fputs("<table><tr><th>points<th>how many<th></tr>\n", stream);
    for (size_t i = 0; i < BINS; i++)
        fprintf(
            stream,
            "<tr><td class=n>%.0f–%.0f<td class=n>%zu<td style=\"width:20em\"><div class=bar style=\"width:%.0f%%\">"
            "</div></tr>\n",
            most * (double)i / BINS, most * (double)(i + 1) / BINS, bins[i], 100.0 * (double)bins[i] / (double)highest);
    fputs("</table>\n", stream);
}

void page_write_spread(FILE *stream, const Table *table)
{
    const TableRow *rows = table->rows;
    size_t count = table->count;
    double *points = malloc((count + 1) * sizeof *points);
    size_t graded = 0;
    for (size_t r = 0; points && r < count; r++)
        if (strcmp(rows[r].student->status, "graded") == 0 || strcmp(rows[r].student->status, "partly graded") == 0)
            points[graded++] = rows[r].student->points;
    if (graded > 0) {
        qsort(points, graded, sizeof *points, compare);
        fprintf(
            stream,
            "<h2>Points</h2>\n<p>Of the %zu graded: lowest %.1f, a quarter below %.1f, half below %.1f, three quarters "
            "below %.1f, highest %.1f.</p>\n",
            graded, points[0], quantile(points, graded, 0.25), quantile(points, graded, 0.5),
            quantile(points, graded, 0.75), points[graded - 1]);
        write_bins(stream, points, graded, rows[0].student->points_max);
    }
    free(points);
}
