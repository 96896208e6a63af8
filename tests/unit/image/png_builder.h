// Builds small PNG files by hand, right or wrong, for the tests: what is built here owes nothing to libpng.
#pragma once

#include <stdint.h>
#include <string.h>

typedef struct {
    unsigned char bytes[4096];
    size_t size;
} PngFile;

static inline void png_put(PngFile *file, const void *bytes, size_t size)
{
    memcpy(file->bytes + file->size, bytes, size);
    file->size += size;
}

static inline void png_put_u32(PngFile *file, uint32_t value)
{
    const unsigned char b[4] = {(unsigned char)(value >> 24), (unsigned char)(value >> 16), (unsigned char)(value >> 8),
                                (unsigned char)value};
    png_put(file, b, 4);
}

static inline uint32_t png_checksum(const unsigned char *bytes, size_t size)
{
    uint32_t crc = UINT32_MAX;
    for (size_t i = 0; i < size; i++) {
        crc ^= bytes[i];
        for (int bit = 0; bit < 8; bit++)
            crc = crc >> 1 ^ (crc & 1 ? 0xedb88320u : 0);
    }
    return ~crc;
}

static inline void png_chunk(PngFile *file, const char *type, const void *data, size_t size)
{
    png_put_u32(file, (uint32_t)size);
    size_t start = file->size;
    png_put(file, type, 4);
    png_put(file, data, size);
    png_put_u32(file, png_checksum(file->bytes + start, size + 4));
}

static inline void png_signature(PngFile *file)
{
    file->size = 0;
    png_put(file, "\x89PNG\r\n\x1a\n", 8);
}

static inline void png_header(PngFile *file, uint32_t width, uint32_t height, const unsigned char rest[5])
{
    PngFile header = {.size = 0};
    png_put_u32(&header, width);
    png_put_u32(&header, height);
    png_put(&header, rest, 5); // depth, colour type, compression, filter, interlace
    png_chunk(file, "IHDR", header.bytes, header.size);
}

// The rows (each with its filter byte) as one stored, that is uncompressed, block of a zlib stream.
static inline void png_data(PngFile *file, const void *rows, size_t size)
{
    PngFile stream = {.size = 0};
    uint32_t a = 1, b = 0; // Adler-32
    for (size_t i = 0; i < size; i++) {
        a = (a + ((const unsigned char *)rows)[i]) % 65521;
        b = (b + a) % 65521;
    }
    const unsigned char start[7] = {0x78,
                                    0x01,
                                    1,
                                    (unsigned char)(size & 255),
                                    (unsigned char)(size >> 8),
                                    (unsigned char)(~size & 255),
                                    (unsigned char)(~size >> 8 & 255)};
    png_put(&stream, start, 7);
    png_put(&stream, rows, size);
    png_put_u32(&stream, b << 16 | a);
    png_chunk(file, "IDAT", stream.bytes, stream.size);
}

static inline void png_end(PngFile *file)
{
    png_chunk(file, "IEND", "", 0);
}
