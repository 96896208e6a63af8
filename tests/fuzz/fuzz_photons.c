// Files of photons, whatever a student's step has put into them: a line or 51 bytes a photon, none more.
#include "fuzz/fuzz.h"
#include "photons/photon_file.h"

static long bytes_behind(const char *path, const char *line, long *lines)
{
    FILE *file = fopen(path, "rb");
    require(file != NULL);
    long behind = -1, all = 0;
    char text[1024];
    while (behind < 0 && fgets(text, sizeof text, file)) {
        all++;
        if (line && strcmp(text, line) == 0)
            behind = ftell(file);
    }
    require(fseek(file, 0, SEEK_END) == 0);
    long size = ftell(file);
    fclose(file);
    *lines = all;
    return size - behind;
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    size_t count = size / sizeof(StoredPhoton);
    StoredPhoton *photons = malloc(count * sizeof *photons + 1);
    char path[512];
    Error error = {""};
    long lines;
    require(photons != NULL);
    memcpy(photons, data, count * sizeof *photons);
    snprintf(path, sizeof path, "%s/photons.ply", fuzz_folder());
    require(photon_file_write(photons, count, path, &error));
    long bytes = bytes_behind(path, "end_header\n", &lines);
    require(count == 0 || bytes % (long)count == 0);
    snprintf(path, sizeof path, "%s/photons.csv", fuzz_folder());
    require(photon_file_write(photons, count, path, &error));
    bytes_behind(path, NULL, &lines);
    require(lines == (long)count + 1);
    free(photons);
    return 0;
}
