// Files of passes: what was read is written again to the same bytes and joined to a picture; or a message with the file's name.
#include "fuzz/fuzz.h"
#include "render/passes/pass_file.h"
#include "steps/steps.h"

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    static bool loaded;
    Error error = {""};
    if (!loaded)
        require(loaded = steps_load(NULL, &error));
    const char *path = fuzz_file("fuzz.part", data, size);
    PassOrigin origin;
    Passes passes = {0};
    if (!pass_file_read(path, &origin, &passes, &error)) {
        require(strstr(error.message, "fuzz.part: ") != NULL);
        return 0;
    }
    Image image;
    char words[1200];
    require(!pass_origin_differs(&origin, &origin, words, sizeof words));
    require(passes_picture(&passes, &image, &error));
    require(pass_file_write(path, &origin, &passes, &error));
    image_free(&image);
    passes_free(&passes);
    return 0;
}
