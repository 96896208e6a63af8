// Who has gone wrong in which way: mistakes and crashes counted by their words.
#include "class/table/class_table.h"
#include "judge/report/text.h"

#include <stdlib.h>
#include <string.h>
#include <unistd.h>

typedef struct {
    size_t step, row;
    const char *name, *said;
} One;

static int compare_words(const void *a, const void *b)
{
    const One *x = a, *y = b;
    int said = strcmp(x->said, y->said);
    return x->step != y->step ? (x->step > y->step) - (x->step < y->step)
           : said             ? said
                              : (x->row > y->row) - (x->row < y->row);
}

static int compare_counts(const void *a, const void *b)
{
    const Mistake *x = a, *y = b;
    return x->count != y->count ? (x->count < y->count) - (x->count > y->count) : (x->who > y->who) - (x->who < y->who);
}

static One *list_all(const Table *table, size_t *count)
{
    One *all = malloc((table->count * STEP_COUNT + 1) * sizeof *all);
    *count = 0;
    for (size_t r = 0; all && r < table->count; r++)
        for (size_t i = 0; i < STEP_COUNT; i++) {
            const Student *student = table->rows[r].student;
            if (*student->steps[i].said)
                all[(*count)++] = (One){i, r, student->steps[i].mistake, student->steps[i].said};
        }
    if (all)
        qsort(all, *count, sizeof *all, compare_words);
    return all;
}

Mistake *mistakes_find(const Table *table, size_t *count, size_t **who)
{
    size_t of_all;
    One *all = list_all(table, &of_all);
    Mistake *mistakes = calloc(of_all + 1, sizeof *mistakes);
    *who = malloc((of_all + 1) * sizeof **who);
    *count = 0;
    for (size_t i = 0; all && mistakes && *who && i < of_all; i++) {
        bool same = i > 0 && all[i].step == all[i - 1].step && strcmp(all[i].said, all[i - 1].said) == 0;
        if (!same)
            mistakes[(*count)++] = (Mistake){all[i].step, 0, all[i].name, all[i].said, *who + i};
        mistakes[*count - 1].count++;
        (*who)[i] = all[i].row;
    }
    free(all);
    if (mistakes)
        qsort(mistakes, *count, sizeof *mistakes, compare_counts);
    return mistakes;
}

// As the gallery's pictures are called: "1_2_pi_missing".
static void tile_name(const Mistake *mistake, char *name, size_t size)
{
    snprintf(name, size, "%s_%s", step_table[mistake->step].id, mistake->name);
    for (char *at = name; *at; at++)
        *at = *at == '.' ? '_' : *at;
}

bool mistake_has_tile(const Table *table, const Mistake *mistake, char *path, size_t size)
{
    char name[120];
    tile_name(mistake, name, sizeof name);
    return *mistake->name && table->pictures &&
           snprintf(path, size, "%s/gallery_%s.png", table->pictures, name) < (int)size && access(path, R_OK) == 0;
}

void mistake_write(FILE *stream, const Table *table, const Mistake *mistake)
{
    char path[4200], anchor[120];
    text_markup(stream, mistake->said);
    if (!table->notes || !mistake_has_tile(table, mistake, path, sizeof path))
        return;
    text_of_tile(step_table[mistake->step].id, mistake->name, anchor, sizeof anchor);
    fputs(" <a href=\"", stream);
    page_link(stream, table->notes);
    fprintf(stream, "/gallery.html#%s\">picture</a>", anchor);
}
