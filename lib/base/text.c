#include "base/text.h"
#include "base/file.h"

#include <ctype.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

char *text_read_file(const char *path, size_t max, size_t *size, Error *error)
{
    char *text = file_read(path, max, size, error);
    if (text && *size == 0) {
        error_set(error, "%s:1:1: the file is empty", path);
        free(text);
        text = NULL;
    }
    return text;
}

// Digits and a point are read here, quickly, and exactly while digits < 2⁵³ and scale ≤ 10²². Others go to strtod, in a
// copy, since no 0 byte need follow the text; nobody here calls setlocale, so that its decimal point is a point.
bool text_number(const char **at, const char *end, double *value)
{
    const char *p = *at;
    bool negative = p < end && *p == '-', any = false, after_point = false;
    double digits = 0.0, scale = 1.0;
    p += p < end && (*p == '-' || *p == '+');
    for (; p < end && ((*p >= '0' && *p <= '9') || (*p == '.' && !after_point)); p++) {
        if (*p == '.') {
            after_point = true;
            continue;
        }
        any = true;
        digits = digits * 10.0 + (*p - '0');
        scale = after_point ? scale * 10.0 : scale;
    }
    if (!any)
        return false;
    *value = (negative ? -digits : digits) / scale;
    if (digits > 9e15 || scale > 1e22 || (p < end && (*p == 'e' || *p == 'E'))) {
        char copy[400], *rest;
        ptrdiff_t length = p - *at + 24 < end - *at ? p - *at + 24 : end - *at; // with the exponent
        snprintf(copy, sizeof copy, "%.*s", (int)length, *at);
        *value = strtod(copy, &rest);
        p = *at + (rest - copy);
    }
    *at = p;
    return true;
}

static bool is_letter(char c)
{
    return isalnum((unsigned char)c) || c == '_';
}

const char *text_find_word(const char *source, const char *word)
{
    size_t length = strlen(word);
    for (const char *c = source; *c; c++) {
        if (c[0] == '/' && c[1] == '/') {
            c += strcspn(c, "\n") - 1;
        } else if (c[0] == '/' && c[1] == '*') {
            const char *end = strstr(c + 2, "*/");
            if (!end)
                return NULL;
            c = end + 1;
        } else if (strncmp(c, word, length) == 0 && !is_letter(c[length]) && (c == source || !is_letter(c[-1]))) {
            return c;
        }
    }
    return NULL;
}

int text_line_of(const char *text, const char *at)
{
    int line = 1;
    for (; text < at; text++)
        line += *text == '\n';
    return line;
}

size_t text_distance(const char *a, const char *b)
{
    size_t row[64], length = strlen(b);
    if (strlen(a) >= 64 || length >= 64)
        return 64;
    for (size_t j = 0; j <= length; j++)
        row[j] = j;
    for (size_t i = 0; a[i]; i++) {
        size_t diagonal = row[0];
        row[0] = i + 1;
        for (size_t j = 0; j < length; j++) {
            size_t replace = diagonal + (tolower((unsigned char)a[i]) != tolower((unsigned char)b[j]));
            size_t shift = 1 + (row[j] < row[j + 1] ? row[j] : row[j + 1]);
            diagonal = row[j + 1];
            row[j + 1] = replace < shift ? replace : shift;
        }
    }
    return row[length];
}

bool text_find_name(const char *name, TextNameAt name_at, const void *list, size_t *number)
{
    const char *known;
    for (*number = 0; (known = name_at(list, *number)); ++*number)
        if (strcmp(known, name) == 0)
            return true;
    return false;
}

TextLine text_suggest(const char *word, TextNameAt name_at, const void *list)
{
    TextLine said = {""};
    const char *nearest = NULL, *name;
    size_t best = 3, first;
    for (size_t i = 0; (name = name_at(list, i)); i++) {
        size_t distance = text_distance(word, name);
        if (distance < best && distance < strlen(name)) {
            best = distance;
            nearest = name;
        }
    }
    if (nearest) {
        text_append(said.text, sizeof said.text, "did you mean '%s'?", nearest);
        return said;
    }
    text_append(said.text, sizeof said.text, "%s", name_at(list, 0) ? "expected one of" : "there are none");
    for (size_t i = 0; (name = name_at(list, i)); i++)
        if (text_find_name(name, name_at, list, &first) && first == i)
            text_append(said.text, sizeof said.text, i ? ", %s" : ": %s", name);
    return said;
}

void text_append(char *text, size_t size, const char *format, ...)
{
    size_t length = strlen(text);
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(text + length, size - length, format, arguments);
    va_end(arguments);
}
