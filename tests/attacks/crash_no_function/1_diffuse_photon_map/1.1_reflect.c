// No attack: calls what is nowhere.
#include "photonlab.h"

Vec3 mirror_of(Vec3 direction, Vec3 normal);

Vec3 reflect(Vec3 direction, Vec3 normal)
{
    return mirror_of(direction, normal);
}
