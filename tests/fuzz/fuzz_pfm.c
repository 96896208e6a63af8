// libFuzzer target: whatever bytes a PFM file holds, reading it ends in an image of finite pixels or in an error.
#include "fuzz/fuzz.h"
#include "image/codec.h"

int LLVMFuzzerTestOneInput(const uint8_t *bytes, size_t size)
{
    Image image;
    Error error = {""};
    bool good = image_read_pfm_memory(&image, bytes, size, "fuzz.pfm", &error);
    require(good ? !error.message[0] && image.width > 0 && image.height > 0 &&
                       image_check_finite(&image, "fuzz.pfm", &error)
                 : !image.pixels && strncmp(error.message, "fuzz.pfm:", 9) == 0);
    image_free(&image);
    return 0;
}
