// Each packet is its own length, its type, and what the type says (tev's Ipc.h); numbers are little-endian, texts end with a 0 byte.
#include "cli/render.h"
#include "base/file.h"

#include <errno.h>
#include <netdb.h>
#include <stdlib.h>
#include <string.h>
#include <sys/socket.h>
#include <sys/time.h>
#include <unistd.h>

enum { PACKET_CREATE = 4, PACKET_UPDATE = 6 }; // the latter in its third version: channels may lie between each other
#define CHANNELS     3
#define MOST_SECONDS 10
#define ROWS_AT_ONCE 64 // of a whole picture

static struct {
    int socket; // −1: there is none, or it has gone
    int problem;
    const char *address, *name;
} viewer = {.socket = -1};

static int connect_to(const char *host, const char *port)
{
    struct addrinfo hints = {.ai_socktype = SOCK_STREAM}, *found = NULL;
    int socket_of = -1;
    // No host means this machine: a bare container knows localhost by no name.
    if (getaddrinfo(strcmp(host, "localhost") == 0 ? NULL : host, port, &hints, &found) != 0)
        return -1;
    for (struct addrinfo *at = found; at && socket_of < 0; at = at->ai_next) {
        struct timeval most = {.tv_sec = MOST_SECONDS};
        socket_of = socket(at->ai_family, at->ai_socktype, at->ai_protocol);
        setsockopt(socket_of, SOL_SOCKET, SO_SNDTIMEO, &most, sizeof most); // connecting, too
#ifdef SO_NOSIGPIPE                                                         // where MSG_NOSIGNAL is unknown
        setsockopt(socket_of, SOL_SOCKET, SO_NOSIGPIPE, &(int){1}, sizeof(int));
#endif
        if (socket_of < 0 || connect(socket_of, at->ai_addr, at->ai_addrlen) == 0)
            continue;
        viewer.problem = errno;
        close(socket_of);
        socket_of = -1;
    }
    freeaddrinfo(found);
    return socket_of;
}

static void send_all(const unsigned char *bytes, size_t size)
{
#ifdef MSG_NOSIGNAL
    int flags = MSG_NOSIGNAL;
#else
    int flags = 0;
#endif
    while (size > 0) {
        ssize_t sent = send(viewer.socket, bytes, size, flags);
        if (sent < 0 && errno == EINTR)
            continue;
        if (sent <= 0) {
            viewer.problem = errno;
            close(viewer.socket);
            viewer.socket = -1;
            return;
        }
        bytes += sent;
        size -= (size_t)sent;
    }
}

static unsigned char *put_text(unsigned char *at, const char *text)
{
    size_t size = strlen(text) + 1;
    memcpy(at, text, size);
    return at + size;
}

static unsigned char *put_long(unsigned char *at, uint32_t value)
{
    return file_put_int(file_put_int(at, value), 0);
}

// Room for a packet with so many bytes behind its head; the length at its beginning is filled in by `finish`.
static unsigned char *begin(unsigned char type, size_t more, unsigned char **at)
{
    unsigned char *packet = malloc(200 + strlen(viewer.name) + more);
    if (!packet)
        return NULL; // this piece is left out
    packet[4] = type;
    packet[5] = 0; // does not ask to be looked at
    *at = put_text(packet + 6, viewer.name);
    return packet;
}

static unsigned char *put_channels(unsigned char *at)
{
    at = file_put_int(at, CHANNELS);
    return put_text(put_text(put_text(at, "R"), "G"), "B");
}

static void finish(unsigned char *packet, const unsigned char *end)
{
    file_put_int(packet, (uint32_t)(end - packet));
    send_all(packet, (size_t)(end - packet));
    free(packet);
}

bool tev_open(const char *address, const char *name, int width, int height, Error *error)
{
    unsigned char *at, *packet;
    char host[256];
    snprintf(host, sizeof host, "%s", address);
    char *colon = strrchr(host, ':');
    if (colon)
        *colon = '\0';
    viewer.address = address;
    viewer.name = name;
    viewer.socket = connect_to(host, colon ? colon + 1 : TEV_PORT);
    packet = viewer.socket >= 0 ? begin(PACKET_CREATE, 0, &at) : NULL;
    if (!packet)
        return error_set(error, "tev at %s: %s; expected HOST or HOST:PORT where tev runs (it listens on " TEV_PORT ")",
                         address, viewer.problem ? strerror(viewer.problem) : "no such host, or no memory");
    at = file_put_int(file_put_int(at, (uint32_t)width), (uint32_t)height);
    finish(packet, put_channels(at));
    return true;
}

void tev_show(void *user, const Image *image, int x, int y, int width, int height)
{
    (void)user;
    unsigned char *at, *packet = NULL;
    if (viewer.socket >= 0)
        packet = begin(PACKET_UPDATE, sizeof(Colour) * (size_t)width * (size_t)height, &at);
    if (!packet)
        return;
    at = put_channels(at);
    const int rectangle[4] = {x, y, width, height};
    for (int i = 0; i < 4; i++)
        at = file_put_int(at, (uint32_t)rectangle[i]);
    for (uint32_t i = 0; i < CHANNELS; i++)
        at = put_long(at, i); // where its first value is, …
    for (int i = 0; i < CHANNELS; i++)
        at = put_long(at, CHANNELS); // … and how far the next
    for (int row = y; row < y + height; row++)
        for (int column = x; column < x + width; column++)
            for (int c = 0; c < CHANNELS; c++)
                at = file_put_float(at, colour_channel(*image_at(image, column, row), c));
    finish(packet, at);
}

void tev_show_all(const Image *image)
{
    for (int row = 0; row < image->height; row += ROWS_AT_ONCE) {
        int left = image->height - row;
        tev_show(NULL, image, 0, row, image->width, left < ROWS_AT_ONCE ? left : ROWS_AT_ONCE);
    }
}

bool tev_close(Error *error)
{
    bool stayed = viewer.socket >= 0 || error_set(error, "tev at %s: %s: the rest of the picture was not shown there",
                                                  viewer.address, strerror(viewer.problem));
    if (viewer.socket >= 0)
        close(viewer.socket);
    viewer.socket = -1;
    return stayed;
}
