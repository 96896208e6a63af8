// A folder that is there while the tests run.
#ifndef PHOTONLAB_TESTS_TEMPORARY_FOLDER_H
#define PHOTONLAB_TESTS_TEMPORARY_FOLDER_H

#include "unit/test.h"

#include <unistd.h>

static char temporary[] = "/tmp/photonlab_test_XXXXXX";

FIXTURE(make_folder)
{
    return mkdtemp(temporary) ? 0 : -1;
}

FIXTURE(remove_folder)
{
    return rmdir(temporary);
}

AROUND_TESTS(make_folder, remove_folder)

#endif
