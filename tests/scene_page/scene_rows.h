// Are the rows of the scene format sound?
#pragma once

#include "scene/file/scene_section.h"

// Does every example load, is every row used by the program, and are rows of one name in one section of one kind? If not,
// says what is wrong on standard error.
bool scene_rows_are_sound(void);
