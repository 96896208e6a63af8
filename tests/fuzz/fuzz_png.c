// libFuzzer target: whatever bytes a PNG file holds, reading it ends in an image of pixels from 0 to 1 or in an error.
#include "fuzz/fuzz.h"
#include "image/codec.h"
#include "unit/image/png_builder.h"

#define MOST_PIXELS 1000000ull // larger ones only cost time here; that they are refused is a unit test's matter

static uint32_t read_u32(const uint8_t *b)
{
    return (uint32_t)b[0] << 24 | (uint32_t)b[1] << 16 | (uint32_t)b[2] << 8 | b[3];
}

// Makes the checksum of every chunk right, without which hardly a changed file would get past its header. A
// file whose last byte is odd keeps its own, so that wrong ones are tried too.
static void mend(uint8_t *bytes, size_t size)
{
    for (size_t at = 8; at + 12 <= size && read_u32(bytes + at) <= size - at - 12;) {
        size_t length = read_u32(bytes + at);
        uint32_t crc = png_checksum(bytes + at + 4, length + 4);
        for (int i = 0; i < 4; i++)
            bytes[at + 8 + length + (size_t)i] = (uint8_t)(crc >> (24 - 8 * i));
        at += length + 12;
    }
}

static void check(const Image *image, const Error *error)
{
    require(!error->message[0] && image->width > 0 && image->height > 0);
    for (size_t i = 0; i < (size_t)image->width * (size_t)image->height; i++)
        for (int channel = 0; channel < 3; channel++) {
            float value = colour_channel(image->pixels[i], channel);
            require(value >= 0.0f && value <= 1.0f);
        }
}

int LLVMFuzzerTestOneInput(const uint8_t *bytes, size_t size)
{
    if (size >= 24 && (unsigned long long)read_u32(bytes + 16) * read_u32(bytes + 20) > MOST_PIXELS &&
        read_u32(bytes + 16) <= IMAGE_MAX_SIDE && read_u32(bytes + 20) <= IMAGE_MAX_SIDE)
        return 0;
    uint8_t *copy = (uint8_t *)fuzz_text(bytes, size);
    if (size && bytes[size - 1] % 2 == 0)
        mend(copy, size);
    Image image;
    Error error = {""};
    if (image_read_png_memory(&image, copy, size, "fuzz.png", &error))
        check(&image, &error);
    else
        require(!image.pixels && strncmp(error.message, "fuzz.png:", 9) == 0);
    image_free(&image);
    free(copy);
    return 0;
}
