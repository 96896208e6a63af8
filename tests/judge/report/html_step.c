// One step on the page: open when there is something to do about it, folded when it passes.
#include "report.h"
#include "base/file.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static void write_paragraph(const char *class, const char *lead, const char *text, FILE *stream)
{
    if (!*text)
        return;
    fprintf(stream, "<p class=\"%s\">%s", class, lead);
    text_put(stream, "%s</p>\n", text);
}

static void write_summary(const Report *report, const ReportStep *step, FILE *stream)
{
    char points[40], most[40];
    text_put(stream,
             "<summary><i class=\"mark\">%s</i><span class=\"id\">%s</span><span class=\"title\">%s <code>%s</code>",
             status_table[step->status].mark, step->id, step->title, step->symbol);
    if (step->hidden && report->teacher)
        fputs(" <em>hidden</em>", stream);
    if (*step->due)
        text_put(stream, " <em>due %s</em>", step->due);
    fprintf(stream, "</span><span class=\"points\">%s / %s</span></summary>\n",
            text_points(step->points, points, sizeof points), text_points(step->points_max, most, sizeof most));
}

static void write_where_to_go(const Report *report, const ReportStep *step, FILE *stream)
{
    fputs("<p class=\"go\">", stream);
    if (*step->where)
        text_put(stream, "<span>where: <code>%s</code></span> ", step->where);
    if (step->status != STATUS_PASS)
        fprintf(stream, "<span>hint: <code>make hint STEP=%s</code></span> ", step->id);
    // Only a plain file name becomes a link: report.json could hold anything.
    if (report->notes && *step->chapter && !strpbrk(step->chapter, ":\\/"))
        text_put(stream, "<span>chapter: <a href=\"%s/%s\">%s</a></span></p>\n", report->notes, step->chapter,
                 step->chapter);
    else
        text_put(stream, "<span>chapter: %s</span></p>\n", step->chapter);
}

static void write_check(const Report *report, const ReportStep *step, const ReportCheck *check, FILE *stream)
{
    char words[400];
    words_of_check(check, words, sizeof words);
    text_put(stream, "<li class=\"%s\"><i class=\"mark\">%s</i><div><b>%s</b>", status_table[check->status].name,
             status_table[check->status].mark, check->title);
    if (check->status != STATUS_PASS && *check->message && strcmp(check->message, step->message) != 0)
        write_paragraph("found", "", check->message, stream);
    if (check->status == STATUS_SKIP)
        write_paragraph("statistic", "", status_table[STATUS_SKIP].words, stream);
    write_paragraph("statistic", "", words, stream);
    if (check->histogram.title)
        html_histogram(&check->histogram, stream);
    if (check->picture.yours)
        html_pictures(report, &check->picture, stream);
    fputs("</div></li>\n", stream);
}

static void write_output(const ReportStep *step, FILE *stream)
{
    if (!*step->output)
        return;
    bool short_enough = strlen(step->output) < 1500;
    fprintf(stream, "<details class=\"output\"%s><summary>What was printed</summary><pre>",
            short_enough && step->status != STATUS_PASS ? " open=\"open\"" : "");
    text_put(stream, "\n%s</pre></details>\n", step->output); // the first line end in a <pre> does not count
}

static bool any_checked(const ReportStep *step)
{
    for (size_t i = 0; i < step->check_count; i++)
        if (step->checks[i].status != STATUS_SKIP && step->checks[i].status != STATUS_TODO)
            return true;
    return false;
}

void html_scatter(const Report *report, const ReportScatter *scatter, FILE *stream)
{
    char words[5000];
    fprintf(stream, "<article class=\"step scatter %s\" id=\"scatter-%d\"><details open=\"open\">\n",
            status_table[scatter->status].name, scatter->stage);
    fprintf(stream,
            "<summary><i class=\"mark\">%s</i><span class=\"title\">The scatter of your photons</span>"
            "<span class=\"points\">stage %d</span></summary>\n<div class=\"body\">\n",
            status_table[scatter->status].mark, scatter->stage);
    words_of_scatter(scatter, words, sizeof words);
    char *rest = NULL;
    for (char *line = strtok_r(words, "\n", &rest); line; line = strtok_r(NULL, "\n", &rest))
        write_paragraph(strcmp(line, scatter->message) == 0 ? "message" : "statistic", "", line, stream);
    if (*scatter->picture)
        html_png(report, scatter->picture,
                 "photons where they came to rest: yours to the left, the reference's to the right", stream);
    if (!*scatter->picture && *scatter->picture_message)
        write_paragraph("note", "The picture is left out: ", scatter->picture_message, stream);
    fputs("</div>\n</details></article>\n", stream);
}

// The picture of the mistake in the notes' gallery, where it has one.
static void write_tile(const Report *report, const ReportStep *step, FILE *stream)
{
    char path[MOST_PATH], anchor[100], wanted[120];
    size_t size;
    Error none = {""};
    if (!report->notes || !*step->mistake)
        return;
    snprintf(path, sizeof path, "%s/%s/gallery.html", report->directory, report->notes);
    text_of_tile(step->id, step->mistake, anchor, sizeof anchor);
    snprintf(wanted, sizeof wanted, "id=\"%s\"", anchor);
    char *gallery = file_read(path, 64u << 20, &size, &none);
    if (gallery && strstr(gallery, wanted))
        text_put(stream, "<p class=\"like\"><a href=\"%s/gallery.html#%s\">a picture that this mistake makes</a></p>\n",
                 report->notes, anchor);
    free(gallery);
}

void html_step(const Report *report, const ReportStep *step, FILE *stream)
{
    bool open = status_is_wrong(step->status);
    fprintf(stream, "<article class=\"step %s\" id=\"step-%s\"><details%s>\n", status_table[step->status].name,
            step->id, open ? " open=\"open\"" : "");
    write_summary(report, step, stream);
    fputs("<div class=\"body\">\n", stream);
    if (step->status == STATUS_TODO)
        write_paragraph("message", "", "Not started. The reference plays in its place.", stream);
    else if (step->status != STATUS_PASS)
        write_paragraph("message", "", *step->message ? step->message : status_table[step->status].words, stream);
    write_paragraph("like", "<b>Looks like:</b> ", step->looks_like, stream);
    write_tile(report, step, stream);
    write_where_to_go(report, step, stream);
    // When nothing could be checked, the compiler's words say why.
    if (any_checked(step)) {
        fputs("<ul class=\"checks\">\n", stream);
        for (size_t i = 0; i < step->check_count; i++)
            write_check(report, step, &step->checks[i], stream);
        fputs("</ul>\n", stream);
    }
    write_output(step, stream);
    fputs("</div>\n</details></article>\n", stream);
}
