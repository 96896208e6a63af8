// Whose submission is which: the roster's column that knows most of their names.
#include "class/table/class_table.h"

#include <ctype.h>
#include <stdlib.h>
#include <string.h>

#define KEY_SIZE 200

// What of a submission's name, or a cell, is compared: Canvas and Moodle leave different marks out of names.
typedef struct {
    char text[KEY_SIZE]; // letters and digits, small ones
    int rank;            // the less, the more of the name it is
    size_t student;
} Key;

static void make_key(const char *from, size_t length, char *key)
{
    size_t used = 0;
    for (size_t i = 0; i < length && used + 1 < KEY_SIZE; i++)
        if (isalnum((unsigned char)from[i]) || (unsigned char)from[i] >= 0x80)
            key[used++] = (char)tolower((unsigned char)from[i]);
    key[used] = '\0';
}

// The number that course systems put behind the first `_`: doejane_LATE_4711_98_x.c, Jane Doe_4711_assignsubmission_file.
static size_t number_in(const char *name, const char **number)
{
    const char *at = strchr(name, '_'), *behind = strstr(name, "_assignsubmission_");
    if (behind) { // a group may stand before it, which may have a `_`
        for (at = behind; at > name && isdigit((unsigned char)at[-1]);)
            at--;
        at = at > name && at[-1] == '_' ? at - 1 : NULL;
    }
    if (at && strncmp(at, "_LATE_", 6) == 0)
        at += 5;
    size_t digits = at ? strspn(at + 1, "0123456789") : 0;
    *number = at ? at + 1 : name;
    return digits > 0 && (at[1 + digits] == '_' || !at[1 + digits]) ? digits : 0;
}

static int compare_keys(const void *a, const void *b)
{
    const Key *x = a, *y = b;
    int text = strcmp(x->text, y->text);
    int rank = x->rank - y->rank;
    return text ? text : rank ? rank : (x->student > y->student) - (x->student < y->student);
}

// Without the date that `make submit` puts behind the name.
static size_t length_of(const char *name)
{
    size_t length = strlen(name), date = strlen("-2026-11-30");
    const char *at = name + length - date;
    return length > date && *at == '-' && strspn(at, "-0123456789") == date ? length - date : length;
}

// Three of each: the whole name, what stands before the first `_`, the number behind.
static Key *make_keys(const Student *students, size_t count)
{
    Key *keys = calloc(3 * count + 1, sizeof *keys);
    for (size_t i = 0; keys && i < count; i++) {
        const char *name = students[i].name, *number;
        size_t digits = number_in(name, &number);
        Key *of = keys + 3 * i;
        make_key(name, length_of(name), of[0].text);
        make_key(name, strcspn(name, "_"), of[1].text);
        make_key(number, digits, of[2].text);
        for (int rank = 0; rank < 3; rank++) {
            of[rank].rank = rank;
            of[rank].student = i;
        }
    }
    if (keys)
        qsort(keys, 3 * count, sizeof *keys, compare_keys);
    return keys;
}

// The key of that text, of the whole name if there is one; of two who share a part of their names none.
static const Key *find_key(const Key *keys, size_t count, const char *text)
{
    size_t low = 0, high = 3 * count;
    while (low < high) {
        size_t middle = (low + high) / 2;
        if (strcmp(keys[middle].text, text) < 0)
            low = middle + 1;
        else
            high = middle;
    }
    const Key *key = keys + low, *next = key + 1, *end = keys + 3 * count;
    if (!*text || key >= end || strcmp(key->text, text) != 0)
        return NULL;
    return next < end && next->rank == key->rank && strcmp(next->text, text) == 0 ? NULL : key;
}

// A cell as it stands; without its @… if it is an address; the number alone of Moodle's "Participant 4711".
static const Key *find_cell(const Key *keys, size_t count, const char *cell)
{
    char text[KEY_SIZE];
    const char *last = strrchr(cell, ' ');
    make_key(cell, strlen(cell), text);
    const Key *found = find_key(keys, count, text);
    if (!found && strchr(cell, '@')) {
        make_key(cell, strcspn(cell, "@"), text);
        found = find_key(keys, count, text);
    }
    if (!found && last && last[1] && strspn(last + 1, "0123456789") == strlen(last + 1))
        found = find_key(keys, count, last + 1);
    return found;
}

// How rows know a submission. Of one group each knows it by its name; what is part of its name may be one row's alone.
typedef enum { BY_NONE, BY_PART, BY_PART_OF_TWO, BY_NAME } Known;

// How many submissions the column knows; `of` and `by` tell which.
static size_t match_column(const Roster *roster, size_t column, const Key *keys, size_t count, size_t *of, Known *by)
{
    size_t known = 0;
    memset(by, 0, (count + 1) * sizeof *by);
    for (int counted = 0; counted < 2; counted++)
        for (size_t r = 1; r < roster->csv.rows; r++) {
            const char *cell = csv_cell(&roster->csv, r, column);
            const Key *key = roster_is_student(roster, r) ? find_cell(keys, count, cell) : NULL;
            Known *its = &by[key ? key->student : count];
            if (!counted && key)
                *its = key->rank == 0 ? BY_NAME : *its == BY_NONE ? BY_PART : *its == BY_PART ? BY_PART_OF_TWO : *its;
            of[r] = key && *its == (key->rank == 0 ? BY_NAME : BY_PART) ? key->student + 1 : 0;
        }
    for (size_t i = 0; i < count; i++)
        known += by[i] == BY_PART || by[i] == BY_NAME;
    return known;
}

static void warn_of_few(const Roster *roster, const char *path, size_t known, const Student *students, size_t count)
{
    fprintf(stderr, "%s knows only %zu of %zu submissions, by its column `%s`. Not in it:", path, known, count,
            csv_cell(&roster->csv, 0, roster->column));
    for (size_t i = 0, said = 0; i < count && said < 6; i++)
        if (!students[i].in_roster) {
            fprintf(stderr, "%s `", said++ ? "," : "");
            for (const char *at = students[i].name; *at; at++)
                fputc((unsigned char)*at < 0x20 ? '?' : *at, stderr);
            fputc('`', stderr);
        }
    fputs(" … COLUMN=… compares another column\n", stderr);
}

// Moodle writes "Monday, 30 November 2026, 2:14 PM", or otherwise, in English; a teacher may write 2026-11-30 14:14.
static bool read_time(const char *text, time_t *time)
{
    static const char *const ways[] = {"%Y-%m-%d %H:%M",      "%Y-%m-%dT%H:%M",          "%A, %d %B %Y, %I:%M %p",
                                       "%A, %d %B %Y, %H:%M", "%A, %B %d, %Y, %I:%M %p", "%d %B %Y, %I:%M %p"};
    for (size_t i = 0; i < sizeof ways / sizeof *ways; i++) {
        struct tm read = {.tm_isdst = -1};
        if (strptime(text, ways[i], &read)) {
            read.tm_isdst = -1;
            *time = mktime(&read);
            return true;
        }
    }
    return false;
}

static bool read_times(const Roster *roster, const char *path, Student *students, Error *error)
{
    size_t column;
    if (!csv_find(&roster->csv, "submitted", &column) && !csv_find(&roster->csv, "Last modified (submission)", &column))
        return true;
    for (size_t r = 1; r < roster->csv.rows; r++) {
        const char *cell = csv_cell(&roster->csv, r, column);
        if (roster->of[r] && *cell && strcmp(cell, "-") != 0 &&
            !read_time(cell, &students[roster->of[r] - 1].submitted))
            return error_set(error, "%s: row %zu: `%s` under `%s` is no time as expected, 2026-11-30 14:14", path,
                             r + 1, cell, csv_cell(&roster->csv, 0, column));
    }
    return true;
}

bool roster_match(Roster *roster, const char *path, const char *wanted, Student *students, size_t count, Error *error)
{
    size_t most = 0, from = 0, to = roster->csv.columns;
    if (wanted && !csv_find(&roster->csv, wanted, &from))
        return error_set(error, "%s: it has no column `%s`", path, wanted);
    if (wanted)
        to = from + 1;
    Key *keys = make_keys(students, count);
    Known *by = calloc(count + 1, sizeof *by);
    roster->of = calloc(roster->csv.rows + 1, sizeof *roster->of);
    bool ok = (keys && by && roster->of) || error_set(error, "no memory");
    roster->column = from;
    for (size_t c = from; ok && c < to; c++) {
        size_t known = match_column(roster, c, keys, count, roster->of, by);
        if (known > most) {
            most = known;
            roster->column = c;
        }
    }
    if (ok && most == 0)
        ok = error_set(error, "%s: %s%s%s has the name of a submission in it, `%.200s` say", path,
                       wanted ? "no row of its column `" : "no column", wanted ? wanted : "", wanted ? "`" : "",
                       students[0].name);
    if (ok)
        match_column(roster, roster->column, keys, count, roster->of, by);
    for (size_t i = 0; ok && i < count; i++)
        students[i].in_roster = by[i] == BY_PART || by[i] == BY_NAME;
    if (ok && 2 * most < count)
        warn_of_few(roster, path, most, students, count);
    free(keys);
    free(by);
    return ok && read_times(roster, path, students, error);
}

bool roster_read(const char *path, Roster *roster, Error *error)
{
    size_t column;
    if (!csv_read(path, &roster->csv, error))
        return false;
    if (csv_find(&roster->csv, "Identifier", &column) && csv_find(&roster->csv, "Grade", &column))
        roster->kind = ROSTER_MOODLE;
    if (csv_find(&roster->csv, "Student", &column) || csv_find(&roster->csv, "LastName", &column))
        if (column == 0 && csv_find(&roster->csv, "ID", &column) && csv_find(&roster->csv, "Section", &column))
            roster->kind = ROSTER_CANVAS;
    return true;
}

// The rows "Points Possible" and "Manual Posting" have no ID; Canvas' own "Student, Test", the teacher who looks at the
// course as a student, is none of the registry's.
bool roster_is_student(const Roster *roster, size_t row)
{
    const Csv *csv = &roster->csv;
    size_t id, registry;
    if (roster->kind != ROSTER_CANVAS)
        return true;
    bool registered = csv_find(csv, "SIS User ID", &registry) && *csv_cell(csv, row, registry);
    return csv_find(csv, "ID", &id) && *csv_cell(csv, row, id) &&
           (registered || strcmp(csv_cell(csv, row, 0), "Student, Test") != 0);
}

void roster_free(Roster *roster)
{
    csv_free(&roster->csv);
    free(roster->of);
}
