// Photons in files, as students' steps left them.
#include "unit/test_common.h"

#include "base/file.h"
#include "photons/photon_file.h"

#include <unistd.h>

TEST(a_power_that_is_no_number_has_a_colour)
{
    const Colour powers[] = {{INFINITY, 1.0f, 0.0f}, {3e38f, 1e38f, 0.0f}, {NAN, NAN, NAN}};
    const char *const colours[] = {",255,0,0,inf,", ",255,255,0,3", "-1,0,0,0,"};
    char path[] = "/tmp/photonlab-XXXXXX.csv";
    int fd = mkstemps(path, 4);
    assert_true(fd >= 0 && close(fd) == 0);
    for (int i = 0; i < 3; i++) {
        StoredPhoton photon = {.power = powers[i]};
        size_t size;
        assert_true(photon_file_write(&photon, 1, path, &said));
        char *text = file_read(path, 4096, &size, &said);
        assert_non_null(text);
        if (!strstr(text, colours[i]))
            fail_msg("expected %s in: %s", colours[i], text);
        free(text);
    }
    unlink(path);
}
