// PFM (Debevec 2001): three lines of text, "PF" or "Pf" (three channels or one), "width height", and a scale
// whose sign tells the byte order (negative: little-endian); then 32-bit floats, the bottom row first.
#include "image/codec.h"
#include "base/file.h"
#include "base/text.h"

#include <stdint.h>
#include <stdlib.h>
#include <string.h>

// The header as it is read: where we are, and in which line.
typedef struct {
    const unsigned char *bytes;
    size_t size, at;
    int line;
    char word[32]; // the last; for messages: cut where it is too long, '?' for what cannot be printed
    const char *name;
    Error *error;
} Header;

static bool is_space(unsigned char c)
{
    return c == ' ' || c == '\t' || c == '\n' || c == '\r';
}

// The next word; empty at the end of the file. Leaves the space behind it: one such byte ends the header, and
// the next may be a pixel that looks like space.
static const char *next_word(Header *header)
{
    for (; header->at < header->size && is_space(header->bytes[header->at]); header->at++)
        header->line += header->bytes[header->at] == '\n';
    memset(header->word, 0, sizeof header->word);
    for (size_t i = 0; header->at < header->size && !is_space(header->bytes[header->at]); header->at++, i++) {
        unsigned char c = header->bytes[header->at];
        size_t last = sizeof header->word - 2;
        header->word[i < last ? i : last] = c > 32 && c < 127 && i < last ? (char)c : '?';
    }
    return header->word;
}

static bool unexpected(const Header *header, const char *expected)
{
    if (!header->word[0])
        return error_set(header->error, "%s:%d: the file ends; expected %s", header->name, header->line, expected);
    return error_set(header->error, "%s:%d: found \"%s\"; expected %s", header->name, header->line, header->word,
                     expected);
}

static bool read_side(Header *header, long *side, const char *expected)
{
    const char *word = next_word(header);
    *side = strtol(word, NULL, 10);
    bool is_side = strspn(word, "0123456789") == strlen(word) && *side >= 1 && *side <= IMAGE_MAX_SIDE;
    return is_side || unexpected(header, expected);
}

static bool is_scale(const char *text)
{
    const char *end = text + strlen(text);
    double scale;
    return text_number(&text, end, &scale) && text == end && scale != 0.0;
}

static float read_float(const unsigned char *b, bool little)
{
    uint32_t bits = 0;
    for (int i = 0; i < 4; i++)
        bits |= (uint32_t)b[little ? i : 3 - i] << (8 * i);
    float value;
    memcpy(&value, &bits, sizeof value);
    return value;
}

static void read_pixels(Image *image, const unsigned char *bytes, size_t channels, bool little)
{
    for (int row = image->height - 1; row >= 0; row--)
        for (int column = 0; column < image->width; column++, bytes += 4 * channels)
            for (size_t c = 0; c < 3; c++)
                colour_set_channel(image_at(image, column, row), (int)c,
                                   read_float(bytes + 4 * (c % channels), little));
}

// The file's length is compared with what the header promises before memory is asked for.
static bool check_length(const Header *header, unsigned long long needed)
{
    unsigned long long found = header->size - header->at;
    char what[64] = "truncated";
    if (found > needed)
        snprintf(what, sizeof what, "%llu bytes too many", found - needed);
    return found == needed ||
           error_set(header->error, "%s: %s: %llu bytes of pixels; expected %llu", header->name, what, found, needed);
}

bool image_read_pfm_memory(Image *image, const unsigned char *bytes, size_t size, const char *name, Error *error)
{
    *image = (Image){0};
    Header header = {.bytes = bytes, .size = size, .line = 1, .name = name, .error = error};
    long width, height;
    const char *word = next_word(&header);
    size_t channels = strcmp(word, "PF") == 0 ? 3 : 1;
    if (channels == 1 && strcmp(word, "Pf") != 0)
        return unexpected(&header, "\"PF\" (three channels) or \"Pf\" (one)");
    if (!read_side(&header, &width, "the width, a whole number from 1 to 65536") ||
        !read_side(&header, &height, "the height, a whole number from 1 to 65536") ||
        !image_check_size(width, height, name, error))
        return false;
    word = next_word(&header);
    if (!is_scale(word))
        return unexpected(&header, "the scale, a number other than 0 (-1: little-endian, 1: big-endian)");
    if (header.at < size)
        header.at++; // the one space that ends the header
    if (!check_length(&header, 4ull * channels * (unsigned long)width * (unsigned long)height) ||
        !image_create(image, (int)width, (int)height, error))
        return false;
    read_pixels(image, bytes + header.at, channels, word[0] == '-');
    if (image_check_finite(image, name, error))
        return true;
    image_free(image);
    return false;
}

// Little-endian on every machine, so that the same image gives the same file.
static bool encode(const Image *image, FILE *stream, const char *name, int bits, Error *error)
{
    (void)name, (void)bits, (void)error;
    fprintf(stream, "PF\n%d %d\n-1.0\n", image->width, image->height);
    for (int row = image->height - 1; row >= 0; row--)
        for (int column = 0; column < image->width; column++) {
            Colour pixel = *image_at(image, column, row);
            unsigned char bytes[12], *at = bytes;
            for (int c = 0; c < 3; c++)
                at = file_put_float(at, colour_channel(pixel, c));
            fwrite(bytes, 1, sizeof bytes, stream);
        }
    return true;
}

const ImageFormat image_format_pfm = {".pfm", "to measure", image_read_pfm_memory, encode, NULL};
