// lecture.html: what the class got wrong, step by step, to be opened in the lecture. No names; nothing beside it is needed.
#include "base/file.h"
#include "class/table/class_table.h"
#include "judge/report/text.h"

#include <stdlib.h>

#define MOST_OF_STEP 5
#define MOST_TILE    (1u << 20) // bytes

static void write_tile(FILE *stream, const Table *table, const Mistake *mistake)
{
    char path[4200];
    size_t size;
    char *bytes = mistake_has_tile(table, mistake, path, sizeof path) ? file_read(path, MOST_TILE, &size, NULL) : NULL;
    if (!bytes)
        return;
    fputs("<br><img alt=\"what it looks like\" loading=lazy src=\"data:image/png;base64,", stream);
    text_base64(stream, (const unsigned char *)bytes, size);
    fputs("\">", stream);
    free(bytes);
}

static void write_step(FILE *stream, const Table *table, size_t step, const Mistake *mistakes, size_t kinds)
{
    size_t passed = count_rows(table, step, STATUS_PASS), shown = 0;
    size_t started = passed + count_rows(table, step, STATUS_FAIL) + count_rows(table, step, STATUS_ERROR);
    if (started == 0)
        return;
    fprintf(stream, "<h3 id=s%s>%s %s</h3>\n<p>%zu of the %zu who began it have it right.</p>\n<div class=kinds>",
            step_table[step].id, step_table[step].id, step_table[step].title, passed, started);
    for (size_t i = 0; i < kinds; i++) {
        const Mistake *m = &mistakes[i];
        if (m->step != step)
            continue;
        if (++shown > MOST_OF_STEP)
            continue;
        fprintf(stream, "<figure><div class=bar style=\"width:%.0f%%\"></div><b>%zu</b> ",
                100.0 * (double)m->count / (double)started, m->count);
        mistake_write(stream, table, m);
        write_tile(stream, table, m);
        fputs("</figure>\n", stream);
    }
    fputs("</div>\n", stream);
    if (shown > MOST_OF_STEP)
        fprintf(stream, "<p>and %zu more kinds.</p>\n", shown - MOST_OF_STEP);
}

void lecture_write(FILE *stream, const Table *table)
{
    size_t kinds, *who;
    Mistake *mistakes = mistakes_find(table, &kinds, &who);
    page_begin(stream, "photonlab: what did my class get wrong?");
    fputs("<h1>What did my class get wrong?</h1>\n", stream);
    for (size_t i = 0; i < STEP_COUNT; i++) {
        if (stage_counts(table, step_table[i].stage) && (i == 0 || step_table[i].stage != step_table[i - 1].stage))
            fprintf(stream, "<h2>Stage %d</h2>\n", step_table[i].stage);
        write_step(stream, table, i, mistakes, kinds);
    }
    fputs("</html>\n", stream);
    free(mistakes);
    free(who);
}
