#include "base/file.h"

#include <stdint.h>
#include <string.h>
#include <strings.h>

const char *file_ending(const char *path)
{
    const char *slash = strrchr(path, '/');
    const char *dot = strrchr(slash ? slash : path, '.');
    return dot ? dot : "";
}

bool file_ends_in(const char *path, const char *ending)
{
    return strcasecmp(file_ending(path), ending) == 0;
}

unsigned char *file_put_int(unsigned char *at, uint32_t value)
{
    for (int i = 0; i < 4; i++)
        *at++ = (unsigned char)(value >> (8 * i));
    return at;
}

unsigned char *file_put_float(unsigned char *at, float value)
{
    uint32_t bits;
    memcpy(&bits, &value, sizeof bits);
    return file_put_int(at, bits);
}
