// The library's frame.
#include "photonlab.h"

Vec3 turn_to(Vec3 local, Vec3 axis)
{
    Frame frame = frame_about(axis);
    return frame_to_world(&frame, local);
}
