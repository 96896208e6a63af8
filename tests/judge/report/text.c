#include "text.h"

#include <stdarg.h>
#include <stdbool.h>
#include <stdlib.h>
#include <string.h>

size_t text_character(const unsigned char *at, size_t left, unsigned long *code)
{
    static const struct {
        unsigned char mask, lead;
        unsigned long least; // a longer spelling of a smaller number is not valid
    } forms[] = {{0x80, 0x00, 0}, {0xe0, 0xc0, 0x80}, {0xf0, 0xe0, 0x800}, {0xf8, 0xf0, 0x10000}};
    for (size_t length = 1; length <= 4 && length <= left; length++) {
        if ((at[0] & forms[length - 1].mask) != forms[length - 1].lead)
            continue;
        *code = at[0] & (unsigned char)~forms[length - 1].mask;
        for (size_t i = 1; i < length; i++) {
            if ((at[i] & 0xc0) != 0x80)
                return 0;
            *code = *code << 6 | (at[i] & 0x3f);
        }
        bool surrogate = *code >= 0xd800 && *code <= 0xdfff;
        return *code >= forms[length - 1].least && *code <= 0x10ffff && !surrogate ? length : 0;
    }
    return 0;
}

// What some format forbids or some viewer obeys: C1 controls, marks that turn the direction of writing, line ends that
// only some know, characters that are none.
static bool is_troublesome(unsigned long code)
{
    return (code >= 0x80 && code <= 0x9f) || code == 0x61c || (code >= 0x200e && code <= 0x200f) ||
           (code >= 0x2028 && code <= 0x202e) || (code >= 0x2066 && code <= 0x2069) || code == 0xfeff ||
           (code >= 0xfdd0 && code <= 0xfdef) || (code & 0xfffe) == 0xfffe;
}

// Appends the character at `from` to `to`; returns how many bytes it had. At most three bytes come out of a bad one.
static size_t clean_character(const unsigned char *from, size_t left, char **to)
{
    unsigned long code = 0;
    size_t length = text_character(from, left, &code);
    if (length == 1 && code == '\r' && left > 1 && from[1] == '\n')
        return 1;
    if (length == 0 || is_troublesome(code)) {
        memcpy(*to, "\xef\xbf\xbd", 3); // U+FFFD, the replacement character
        *to += 3;
    } else if ((code < 0x20 && code != '\n' && code != '\t') || code == 0x7f) {
        unsigned char picture[] = {0xe2, 0x90, (unsigned char)(code == 0x7f ? 0xa1 : 0x80 + code)}; // from U+2400 on
        memcpy(*to, picture, 3);
        *to += 3;
    } else {
        memcpy(*to, from, length);
        *to += length;
    }
    return length > 0 ? length : 1;
}

// Bytes of `text` from `at` on to the next character's first one.
static size_t to_boundary(const char *text, size_t at)
{
    while ((text[at] & 0xc0) == 0x80)
        at++;
    return at;
}

// Cuts the middle: the first lines tell what broke, the last ones where it ended.
static void cut_middle(char *text, size_t size, size_t most)
{
    char note[64];
    size_t head = to_boundary(text, most / 2), tail = to_boundary(text, size - most / 2);
    int length = snprintf(note, sizeof note, "\n… %zu bytes left out …\n", tail - head);
    if (tail < head + (size_t)length)
        return; // leaving out would save nothing
    memcpy(text + head, note, (size_t)length);
    memmove(text + head + length, text + tail, size - tail + 1);
}

char *text_clean(const char *bytes, size_t size, size_t most)
{
    if (size > (size_t)-1 / 3 - 1)
        return NULL;
    char *clean = malloc(3 * size + 1), *to = clean;
    if (!clean)
        return NULL;
    for (size_t i = 0; i < size;)
        i += clean_character((const unsigned char *)bytes + i, size - i, &to);
    *to = '\0';
    if ((size_t)(to - clean) > most)
        cut_middle(clean, (size_t)(to - clean), most);
    char *fitting = realloc(clean, strlen(clean) + 1);
    return fitting ? fitting : clean;
}

// Text with words in the place of some characters.
static void put_replaced(FILE *stream, const char *text, const char *characters, const char *const *words)
{
    for (; *text; text++) {
        const char *found = strchr(characters, *text);
        if (found)
            fputs(words[found - characters], stream);
        else
            fputc(*text, stream);
    }
}

void text_markup(FILE *stream, const char *text)
{
    static const char *const words[] = {"&amp;", "&lt;", "&gt;", "&quot;", "&#39;"}; // > so that ]]> never comes about
    put_replaced(stream, text, "&<>\"'", words);
}

void text_put(FILE *stream, const char *format, ...)
{
    va_list arguments;
    va_start(arguments, format);
    for (; *format; format++) {
        if (*format != '%')
            fputc(*format, stream);
        else if (*++format == 's')
            text_markup(stream, va_arg(arguments, const char *));
        else if (*format == 'd')
            fprintf(stream, "%d", va_arg(arguments, int));
        else
            fputc(*format, stream);
    }
    va_end(arguments);
}

void text_quoted(FILE *stream, const char *text)
{
    static const char *const words[] = {"\\\"", "\\\\", "\\n", "\\t"};
    fputc('"', stream);
    put_replaced(stream, text, "\"\\\n\t", words);
    fputc('"', stream);
}

void text_base64(FILE *stream, const unsigned char *bytes, size_t size)
{
    static const char digits[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    for (size_t i = 0; i < size; i += 3) {
        unsigned long three = (unsigned long)bytes[i] << 16;
        three |= i + 1 < size ? (unsigned long)bytes[i + 1] << 8 : 0;
        three |= i + 2 < size ? (unsigned long)bytes[i + 2] : 0;
        fputc(digits[three >> 18], stream);
        fputc(digits[three >> 12 & 63], stream);
        fputc(i + 1 < size ? digits[three >> 6 & 63] : '=', stream);
        fputc(i + 2 < size ? digits[three & 63] : '=', stream);
    }
}

const char *text_points(double points, char *words, size_t size)
{
    snprintf(words, size, "%.2f", points);
    char *end = words + strlen(words) - 1;
    while (*end == '0')
        *end-- = '\0';
    if (*end == '.')
        *end = '\0';
    return words;
}

void text_of_tile(const char *step, const char *mistake, char *anchor, size_t size)
{
    snprintf(anchor, size, "m-%s-%s", step, mistake);
    for (char *c = anchor; *c; c++)
        *c = *c == '.' || *c == '_' ? '-' : *c;
}
