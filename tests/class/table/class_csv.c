#include "class/table/class_table.h"
#include "base/array.h"
#include "base/file.h"

#include <stdlib.h>
#include <string.h>
#include <strings.h>

#define MOST_CSV (64u << 20)

// The first of , ; and tab that stands in the header, outside of quotes, which may hold line ends as well.
static char separator_of(const char *text)
{
    const char *const kinds = ",;\t", *best = kinds + 3;
    bool quoted = false, at_start = true;
    for (; *text && (quoted || !strchr("\r\n", *text)); text++) {
        const char *kind = strchr(kinds, *text);
        if (*text == '"' && (quoted || at_start)) {
            bool doubled = quoted && text[1] == '"';
            quoted = quoted == doubled;
            text += doubled;
        } else if (!quoted && kind && kind < best) {
            best = kind;
        }
        at_start = kind != NULL;
    }
    return *best ? *best : ',';
}

// Reads one cell in place: quotes go, doubled ones become one. Returns what stood behind it ('\0' at the end).
static char take_cell(char **at, char separator, char **cell)
{
    char *from = *at, *to = *at;
    *cell = to;
    if (*from == '"') {
        from++;
        while (*from && !(from[0] == '"' && from[1] != '"')) {
            from += from[0] == '"';
            *to++ = *from++;
        }
        from += *from == '"';
    }
    while (*from && *from != separator && *from != '\n' && *from != '\r')
        *to++ = *from++;
    char end = *from;
    if (end == '\r' && from[1] == '\n') {
        from++;
        end = '\n';
    }
    *at = from + (*from != '\0');
    *to = '\0';
    return end == '\r' ? '\n' : end;
}

static bool add_cell(Csv *csv, size_t *room, size_t count, char *cell, const char *path, Error *error)
{
    if (!array_reserve(&csv->cells, count + 1, room, sizeof cell))
        return error_set(error, "%s: no memory", path);
    csv->cells[count] = cell;
    return true;
}

static bool read_rows(Csv *csv, char *at, const char *path, Error *error)
{
    size_t room = 0, count = 0;
    char separator = separator_of(at);
    while (*at) {
        size_t in_row = 0, blank = *at == '\n' ? 1 : strncmp(at, "\r\n", 2) == 0 ? 2 : 0;
        at += blank;
        if (blank > 0)
            continue;
        char end = separator;
        while (end == separator) {
            char *cell;
            end = take_cell(&at, separator, &cell);
            if (csv->rows > 0 && in_row == csv->columns && *cell)
                return error_set(error, "%s: row %zu has more cells than the header", path, csv->rows + 1);
            if ((csv->rows == 0 || in_row < csv->columns) && !add_cell(csv, &room, count++, cell, path, error))
                return false;
            in_row += csv->rows == 0 || in_row < csv->columns;
        }
        if (csv->rows++ == 0)
            csv->columns = in_row;
        for (; in_row < csv->columns; in_row++)
            if (!add_cell(csv, &room, count++, "", path, error))
                return false;
    }
    return csv->rows > 0 || error_set(error, "%s: it has no header", path);
}

bool csv_read(const char *path, Csv *csv, Error *error)
{
    size_t size;
    *csv = (Csv){.bytes = file_read(path, MOST_CSV, &size, error)};
    if (!csv->bytes)
        return false;
    if (strlen(csv->bytes) != size)
        return error_set(error, "%s: holds a zero byte; is it a CSV in UTF-8?", path);
    csv->marked = strncmp(csv->bytes, MARK, 3) == 0;
    return read_rows(csv, csv->bytes + (csv->marked ? 3 : 0), path, error);
}

bool csv_find(const Csv *csv, const char *title, size_t *column)
{
    for (size_t c = 0; c < csv->columns; c++)
        if (strcasecmp(csv_cell(csv, 0, c), title) == 0) {
            *column = c;
            return true;
        }
    return false;
}

const char *csv_cell(const Csv *csv, size_t row, size_t column)
{
    return csv->cells[row * csv->columns + column];
}

void csv_write(FILE *stream, const char *cell, bool first)
{
    if (!first)
        fputc(',', stream);
    if (!cell[strcspn(cell, ",\"\r\n;\t")] && cell[0] != ' ') {
        fputs(cell, stream);
        return;
    }
    fputc('"', stream);
    for (; *cell; cell++)
        fputs(*cell == '"' ? "\"\"" : (char[]){*cell, '\0'}, stream);
    fputc('"', stream);
}

void csv_write_text(FILE *stream, const char *cell, bool first)
{
    char safe[8192];
    snprintf(safe, sizeof safe, "%s%s", *cell && strchr("=+-@", *cell) ? "'" : "", cell);
    for (char *at = safe; *at; at++)
        if (*at == '\n' || *at == '\r')
            *at = ' ';
    csv_write(stream, safe, first);
}

void csv_free(Csv *csv)
{
    free(csv->cells);
    free(csv->bytes);
    *csv = (Csv){.bytes = NULL};
}
