// A folder that is there while the tests run.
#ifndef PHOTONLAB_TESTS_TEMPORARY_FOLDER_H
#define PHOTONLAB_TESTS_TEMPORARY_FOLDER_H

#include "unit/test.h"

#include <unistd.h>

static char temporary[] = "/tmp/photonlab_test_XXXXXX";

static int make_folder(void **state)
{
    (void)state;
    return mkdtemp(temporary) ? 0 : -1;
}

static int remove_folder(void **state)
{
    (void)state;
    return rmdir(temporary);
}

AROUND_TESTS(make_folder, remove_folder)

#endif
