// What the tests of images share: images that are freed at the test's end.
#pragma once

#include "unit/test_common.h"

static inline Image make_image(int width, int height)
{
    Image image;
    assert_true(image_create(&image, width, height, NULL));
    return *own_image(kept(&image, sizeof image));
}

static inline Image image_of_file(const char *path)
{
    Image image;
    assert_true(image_read(&image, path, NULL));
    return *own_image(kept(&image, sizeof image));
}
