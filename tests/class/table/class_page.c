// index.html: the class at a glance. One file, no scripts.
#include "judge/report/text.h"
#include "class/table/class_table.h"

#include <string.h>

// A path in a link: every byte but the harmless ones as %XX.
static void link_path(FILE *stream, const char *path)
{
    for (; *path; path++)
        if (strchr("abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-", *path) || *path == '.')
            fputc(*path, stream);
        else
            fprintf(stream, "%%%02X", (unsigned char)*path);
}

static const char style[] =
    "<style>body{font:15px/1.4 system-ui,sans-serif;margin:2em;color:#222;background:#fff}table{border-collapse:collapse}"
    "th,td{padding:.15em .5em;border-bottom:1px solid #ddd;text-align:left;vertical-align:top}"
    "td.n{text-align:right;font-variant-numeric:tabular-nums}.pass{color:#066b2b}.fail,.error{color:#b3261e}"
    ".todo,.skip{color:#777}.bar{background:#8cb4e8;height:.8em}td.note{border-top:none;padding-left:2em;max-width:60em;overflow-wrap:anywhere}"
    "tr.noted td{border-bottom:none}h2{margin-top:2em}"
    "@media(prefers-color-scheme:dark){body{color:#ddd;background:#181818}th,td{border-color:#444}.pass{color:#6c6}"
    ".fail,.error{color:#f88}}</style>\n";

static const char *mark_of(const char *status)
{
    for (size_t i = 0; i < STATUSES; i++)
        if (strcmp(status, status_table[i].name) == 0)
            return status_table[i].mark;
    return "";
}

static void write_overview(FILE *stream, const TableRow *rows, size_t count)
{
    fputs("<h2>Steps</h2>\n<table><tr><th>step<th>passed<th>wrong<th>crashed<th>not started<th></tr>\n", stream);
    for (size_t i = 0; i < STEP_COUNT; i++) {
        size_t pass = 0, fail = 0, error = 0;
        for (size_t r = 0; r < count; r++) {
            const char *status = rows[r].student->steps[i].status;
            pass += strcmp(status, "pass") == 0;
            fail += strcmp(status, "fail") == 0;
            error += strcmp(status, "error") == 0;
        }
        fprintf(stream,
                "<tr><td>%s %s<td class=n>%zu<td class=n>%zu<td class=n>%zu<td class=n>%zu"
                "<td style=\"width:12em\"><div class=bar style=\"width:%.0f%%\"></div></tr>\n",
                step_table[i].id, step_table[i].title, pass, fail, error, count - pass - fail - error,
                count ? 100.0 * (double)pass / (double)count : 0.0);
    }
    fputs("</table>\n", stream);
}

typedef struct {
    const char *step, *mistake;
    size_t count;
} Mistake;

static void count_mistake(Mistake *mistakes, size_t *kinds, size_t most, const char *step, const char *mistake)
{
    for (size_t i = 0; i < *kinds; i++)
        if (mistakes[i].step == step && strcmp(mistakes[i].mistake, mistake) == 0) {
            mistakes[i].count++;
            return;
        }
    if (*kinds < most)
        mistakes[(*kinds)++] = (Mistake){step, mistake, 1};
}

#define MOST_MISTAKES  400
#define SHOWN_MISTAKES 15

// The sentence that the student reads; its short name where there is none.
static const char *mistake_of(const Student *student, size_t step)
{
    return *student->steps[step].looks_like ? student->steps[step].looks_like : student->steps[step].mistake;
}

static void write_mistakes(FILE *stream, const TableRow *rows, size_t count)
{
    static Mistake mistakes[MOST_MISTAKES];
    size_t kinds = 0;
    for (size_t r = 0; r < count; r++)
        for (size_t i = 0; i < STEP_COUNT; i++)
            if (*mistake_of(rows[r].student, i))
                count_mistake(mistakes, &kinds, MOST_MISTAKES, step_table[i].id, mistake_of(rows[r].student, i));
    if (kinds == 0)
        return;
    fputs("<h2>The commonest mistakes</h2>\n<table><tr><th>how many<th>step<th>looks like</tr>\n", stream);
    for (int shown = 0; shown < SHOWN_MISTAKES; shown++) {
        size_t most = 0;
        for (size_t i = 1; i < kinds; i++)
            most = mistakes[i].count > mistakes[most].count ? i : most;
        if (mistakes[most].count == 0)
            break;
        fprintf(stream, "<tr><td class=n>%zu<td>%s<td>", mistakes[most].count, mistakes[most].step);
        text_markup(stream, mistakes[most].mistake);
        fputs("</tr>\n", stream);
        mistakes[most].count = 0;
    }
    fputs("</table>\n", stream);
}

static bool has_note(const Student *student)
{
    bool noted = *student->message;
    for (size_t i = 0; i < STEP_COUNT; i++)
        noted = noted || *mistake_of(student, i);
    return noted;
}

// On a line of its own, as wide as the table: it is long, and a roster may have many columns.
static void write_note(FILE *stream, const Student *student, size_t columns)
{
    fprintf(stream, "<tr><td class=note colspan=%zu>", columns);
    text_markup(stream, student->message);
    for (size_t i = 0; i < STEP_COUNT; i++)
        if (*mistake_of(student, i)) {
            fprintf(stream, "<br>%s: ", step_table[i].id);
            text_markup(stream, mistake_of(student, i));
        }
    fputs("</tr>\n", stream);
}

static void write_student(FILE *stream, const Csv *roster, const TableRow *row)
{
    const Student *s = row->student;
    bool noted = has_note(s);
    fputs(noted ? "<tr class=noted>" : "<tr>", stream);
    for (size_t c = 0; roster && c < roster->columns; c++) {
        fputs("<td>", stream);
        text_markup(stream, row->roster_row ? csv_cell(roster, row->roster_row, c) : "");
    }
    fputs("<td>", stream);
    if (s->has_page) {
        fputs("<a href=\"", stream);
        link_path(stream, s->name);
        fputs("/index.html\">", stream);
    }
    text_markup(stream, s->name);
    fprintf(stream, "%s<td>%s%s<td class=n>%.1f", s->has_page ? "</a>" : "", s->status,
            roster && !s->in_roster ? ", not in the roster" : "", s->points);
    for (size_t i = 0; i < STEP_COUNT; i++)
        fprintf(stream, "<td class=%s>%s", s->steps[i].there ? s->steps[i].status : "skip",
                mark_of(s->steps[i].status));
    fputs("</tr>\n", stream);
    if (noted)
        write_note(stream, s, (roster ? roster->columns : 0) + 3 + STEP_COUNT);
}

void page_write(FILE *stream, const Csv *roster, const TableRow *rows, size_t count)
{
    double sum = 0.0;
    size_t graded = 0;
    for (size_t r = 0; r < count; r++) {
        graded += strcmp(rows[r].student->status, "graded") == 0;
        sum += rows[r].student->points;
    }
    fputs("<!DOCTYPE html>\n<html lang=en><meta charset=utf-8><meta name=viewport content=\"width=device-width\">"
          "<title>photonlab: the class</title>\n",
          stream);
    fputs(style, stream);
    fprintf(stream,
            "<h1>The class</h1>\n<p>%zu lines, %zu graded; mean of all %.1f points. Points as numbers: "
            "<a href=class.csv>class.csv</a>. ✓ passed, ✗ wrong, ! crashed, ○ not started.</p>\n",
            count, graded, count ? sum / (double)count : 0.0);
    page_write_spread(stream, rows, count);
    write_overview(stream, rows, count);
    write_mistakes(stream, rows, count);
    fputs("<h2>Submissions</h2>\n<table><tr>", stream);
    for (size_t c = 0; roster && c < roster->columns; c++) {
        fputs("<th>", stream);
        text_markup(stream, csv_cell(roster, 0, c));
    }
    fputs("<th>submission<th>status<th>points", stream);
    for (size_t i = 0; i < STEP_COUNT; i++)
        fprintf(stream, "<th title=\"%s\">%s", step_table[i].title, step_table[i].id);
    fputs("</tr>\n", stream);
    for (size_t r = 0; r < count; r++)
        write_student(stream, roster, &rows[r]);
    fputs("</table>\n</html>\n", stream);
}
