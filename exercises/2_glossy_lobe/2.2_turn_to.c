// Step 2.2: turn a direction from +z to an axis. Contract: lib/steps/2_glossy_lobe.h
#include "photonlab.h"

Vec3 turn_to(Vec3 local, Vec3 axis)
{
    todo("2.2"), (void)local; // take this line away when you start

    // 1. Find two unit vectors at right angles to the axis and to each other: start from whichever of x and y is
    // farther from it.

    // 2. Go as far along each of the three as `local` goes along x, y and z.

    return axis;
}
