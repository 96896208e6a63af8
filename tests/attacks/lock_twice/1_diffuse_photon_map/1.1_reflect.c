// Takes a lock that it has.
#include "photonlab.h"

#include <pthread.h>

Vec3 reflect(Vec3 direction, Vec3 normal)
{
    pthread_mutex_t lock = PTHREAD_MUTEX_INITIALIZER;
    pthread_mutex_lock(&lock);
    pthread_mutex_lock(&lock);
    return vec3_along(direction, normal, -2.0f * vec3_dot(direction, normal));
}
