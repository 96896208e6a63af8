#define _GNU_SOURCE // vasprintf
#include "judge/judge.h"

#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/ioctl.h>
#include <unistd.h>

#define INDENT "        "
#define WIDEST 100 // columns: longer lines are hard to read

Terminal terminal_find(void)
{
    Terminal terminal = {.width = 80};
    struct winsize size;
    const char *columns = getenv("COLUMNS"), *no_colour = getenv("NO_COLOR"), *kind = getenv("TERM");
    bool there = isatty(STDOUT_FILENO);
    if (columns && atoi(columns) > 0)
        terminal.width = atoi(columns);
    else if (there && ioctl(STDOUT_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 0)
        terminal.width = size.ws_col;
    terminal.width = terminal.width < 40 ? 40 : terminal.width > WIDEST ? WIDEST : terminal.width;
    terminal.colour = there && !(no_colour && *no_colour) && !(kind && strcmp(kind, "dumb") == 0);
    return terminal;
}

void terminal_paint(const Terminal *terminal, const char *code)
{
    if (terminal->colour)
        fputs(code, stdout);
}

int terminal_columns(const char *text, size_t size)
{
    int columns = 0;
    for (size_t i = 0; i < size;) {
        unsigned long code = 0;
        size_t length = text_character((const unsigned char *)text + i, size - i, &code);
        columns += !(code >= 0x300 && code <= 0x36f);
        i += length > 0 ? length : 1;
    }
    return columns;
}

char *terminal_clean(const char *text)
{
    char *copy = text_clean(text, strlen(text), 65536);
    if (!copy)
        exit(3);
    return copy;
}

void print_wrapped(const Terminal *terminal, const char *paint, const char *format, ...)
{
    char *text, *rest = NULL;
    va_list arguments;
    va_start(arguments, format);
    int length = vasprintf(&text, format, arguments);
    va_end(arguments);
    char *words = terminal_clean(length >= 0 ? text : "");
    if (length >= 0)
        free(text);
    int column = 0, widest = terminal->width - (int)sizeof INDENT + 1;
    terminal_paint(terminal, paint);
    fputs(INDENT, stdout);
    for (char *word = strtok_r(words, " \n\t", &rest); word; word = strtok_r(NULL, " \n\t", &rest)) {
        int width = terminal_columns(word, strlen(word));
        if (column > 0 && column + 1 + width > widest) {
            fputs("\n" INDENT, stdout);
            column = 0;
        }
        printf("%s%s", column > 0 ? " " : "", word);
        column += width + (column > 0);
    }
    putchar('\n');
    if (*paint)
        terminal_paint(terminal, "\033[0m");
    free(words);
}

static size_t lines_in(const char *text)
{
    size_t lines = 0;
    for (; *text; text = text + strcspn(text, "\n") + (text[strcspn(text, "\n")] == '\n'))
        lines++;
    return lines;
}

void print_lines(const char *text, size_t before)
{
    char *lines = terminal_clean(text), *line = lines;
    size_t count = lines_in(lines), after = MOST_LINES - before;
    for (size_t i = 0; i < count; i++) {
        size_t length = strcspn(line, "\n");
        if (count <= MOST_LINES || i < before || i >= count - after)
            printf(INDENT "%.*s\n", (int)length, line);
        else if (i == before)
            printf(INDENT "… %zu lines%s\n", count - MOST_LINES, after ? " between" : " more");
        line += length + (line[length] == '\n');
    }
    free(lines);
}
