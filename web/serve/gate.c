// Who may ask. Any page that the student's browser has open can send requests to this machine, and any name can be made to lead
// here; so a request has to carry the token of the address that was printed, come from the page itself, and name this machine.
#include "web/serve/serve.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define TOKEN 32 // letters

// Part of a host's name.
static bool is_name(const char *text)
{
    return text && text[0] && strlen(text) < 120 &&
           text[strspn(text, "abcdefghijklmnopqrstuvwxyz0123456789-.")] == '\0';
}

bool gate_make(Gate *gate, int port)
{
    unsigned char bytes[TOKEN / 2];
    const char *name = getenv("CODESPACE_NAME"), *domain = getenv("GITHUB_CODESPACES_PORT_FORWARDING_DOMAIN");
    FILE *random = fopen("/dev/urandom", "rb");
    bool fine = random && fread(bytes, sizeof bytes, 1, random) == 1;
    if (random)
        fclose(random);
    for (size_t i = 0; fine && i < sizeof bytes; i++)
        snprintf(gate->token + 2 * i, 3, "%02x", bytes[i]);
    gate->port = port;
    if (is_name(name) && is_name(domain))
        snprintf(gate->forwarded, sizeof gate->forwarded, "%s-%d.%s", name, port, domain);
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

// The page's own: at this machine's name, or at the one that Codespaces has for it, which becomes localhost on the way, or not: in
// the Host, in the Origin, in both.
static bool is_own(const Gate *gate, const char *origin, const char *host)
{
    char local[32];
    snprintf(local, sizeof local, "localhost:%d", gate->port);
    if (strncmp(origin, "http://", 7) == 0 && strcmp(origin + 7, host) == 0)
        return true;
    size_t scheme = strncmp(origin, "https://", 8) == 0 ? 8 : strncmp(origin, "http://", 7) == 0 ? 7 : 0;
    return gate->forwarded[0] && scheme &&
           (strcmp(origin + scheme, local) == 0 || strcmp(origin + scheme, gate->forwarded) == 0);
}

// Somebody opens the page itself. In Codespaces the way there leads over GitHub's pages, and nothing of it is given to those.
static bool is_visit(const Gate *gate, struct MHD_Connection *connection, const char *url)
{
    const char *to = MHD_lookup_connection_value(connection, MHD_HEADER_KIND, "Sec-Fetch-Dest");
    return gate->forwarded[0] && to && strcmp(to, "document") == 0 && strlen(url) == 1 + TOKEN + 1;
}

const char *gate_refuses(const Gate *gate, struct MHD_Connection *connection, const char *method, const char *url,
                         const char **path)
{
    const char *host = MHD_lookup_connection_value(connection, MHD_HEADER_KIND, "Host");
    const char *origin = MHD_lookup_connection_value(connection, MHD_HEADER_KIND, "Origin");
    const char *site = MHD_lookup_connection_value(connection, MHD_HEADER_KIND, "Sec-Fetch-Site");
    if (!host || !(is_here(host) || (gate->forwarded[0] && strcmp(host, gate->forwarded) == 0)))
        return "it does not name this machine";
    if (origin && !is_own(gate, origin, host))
        return "it comes from another page";
    if (site && strcmp(site, "same-origin") != 0 && strcmp(site, "none") != 0 && !is_visit(gate, connection, url))
        return "it comes from another site";
    if (url[0] != '/' || !is_token(url + 1, gate->token))
        return "it has not the address that was printed";
    if (strcmp(method, "GET") != 0 && strcmp(method, "POST") != 0)
        return "it wants something else than to get or to tell";
    *path = url + 1 + TOKEN;
    return NULL;
}
