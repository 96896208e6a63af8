// Who may ask. Any page that the student's browser has open can send requests to this machine, and any name can be made to lead
// here; so a request has to carry the token of the address that was printed, come from the page itself, and name this machine.
#include "web/serve/serve.h"

#include <stdio.h>
#include <string.h>

#define TOKEN 32 // letters

bool gate_make_token(char token[TOKEN + 1])
{
    unsigned char bytes[TOKEN / 2];
    FILE *random = fopen("/dev/urandom", "rb");
    bool fine = random && fread(bytes, sizeof bytes, 1, random) == 1;
    if (random)
        fclose(random);
    for (size_t i = 0; fine && i < sizeof bytes; i++)
        snprintf(token + 2 * i, 3, "%02x", bytes[i]);
    return fine;
}

// In the same time wherever they differ.
static bool is_token(const char *given, const char *token)
{
    unsigned char difference = 0;
    if (strcspn(given, "/") != TOKEN)
        return false;
    for (size_t i = 0; i < TOKEN; i++)
        difference |= (unsigned char)(given[i] ^ token[i]);
    return difference == 0;
}

// This machine, at any port: one that was forwarded may have another number.
static bool is_here(const char *host)
{
    static const char *const NAMES[] = {"127.0.0.1", "localhost"};
    for (size_t i = 0; i < sizeof NAMES / sizeof *NAMES; i++) {
        size_t length = strlen(NAMES[i]);
        if (strncmp(host, NAMES[i], length) == 0 && (host[length] == '\0' || host[length] == ':'))
            return host[length] == '\0' || strspn(host + length + 1, "0123456789") == strlen(host + length + 1);
    }
    return false;
}

const char *gate_refuses(struct MHD_Connection *connection, const char *method, const char *url, const char *token,
                         const char **path)
{
    const char *host = MHD_lookup_connection_value(connection, MHD_HEADER_KIND, "Host");
    const char *origin = MHD_lookup_connection_value(connection, MHD_HEADER_KIND, "Origin");
    const char *site = MHD_lookup_connection_value(connection, MHD_HEADER_KIND, "Sec-Fetch-Site");
    if (!host || !is_here(host))
        return "it does not name this machine";
    if (origin && (strncmp(origin, "http://", 7) != 0 || strcmp(origin + 7, host) != 0))
        return "it comes from another page";
    if (site && strcmp(site, "same-origin") != 0 && strcmp(site, "none") != 0)
        return "it comes from another site";
    if (url[0] != '/' || !is_token(url + 1, token))
        return "it has not the address that was printed";
    if (strcmp(method, "GET") != 0 && strcmp(method, "POST") != 0)
        return "it wants something else than to get or to tell";
    *path = url + 1 + TOKEN;
    return NULL;
}
