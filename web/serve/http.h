// Inside of the server: who is connected, and what is answered.
#pragma once

#include "web/serve/serve.h"

// What can be asked for.
typedef enum {
    NAME_PAGE,
    NAME_SCRIPT,
    NAME_MODULE,
    NAME_STUDENTS,
    NAME_STATE,
    NAME_FAULT,
    NAME_NEXT,
    NAME_HINT,
    NAMES
} Name;
// A connection, so that one that asks nothing can be ended.
typedef struct Visit {
    struct Visit *next;
    int socket;
    double since; // clock_seconds() of its beginning, or of the last question or answer
    bool asked;   // and not answered yet
} Visit;

typedef struct Waiting { // for another state
    struct Waiting *next;
    struct MHD_Connection *connection;
    double since;
} Waiting;

#define MOST_BODY 2048 // bytes
#define REASONS   16   // to refuse
typedef struct {
    char body[MOST_BODY + 1];
    size_t size;
    bool waited;
} Question;

struct Server {
    struct MHD_Daemon *daemon;
    Tab *tab;
    char *bytes[NAMES];
    size_t sizes[NAMES];
    Gate gate;
    int visit_count;
    struct {
        const char *what;
        int times;
    } told[REASONS];
    Visit *visits;
    Waiting *waiting;
};

// The file whose bytes are given for a name; NULL: none.
const char *server_file(Name name);
enum MHD_Result server_answer(void *server, struct MHD_Connection *connection, const char *url, const char *method,
                              const char *version, const char *bytes, size_t *size, void **kept);
void server_answered(void *server, struct MHD_Connection *connection, void **kept,
                     enum MHD_RequestTerminationCode code);

// To the terminal, some times.
void server_tell(Server *server, const char *what, const char *more);
