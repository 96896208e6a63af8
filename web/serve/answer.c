// What is answered: a few names and nothing else; no name leads to a file.
#include "web/serve/http.h"
#include "base/parallel.h"

#include <stdlib.h>
#include <string.h>

static const struct {
    const char *path, *file, *type;
    bool tells; // POST
} NAMED[NAMES] = {
    [NAME_PAGE] = {"/", "tab.html", "text/html; charset=utf-8", false},
    [NAME_SCRIPT] = {"/tab.js", "tab.js", "text/javascript; charset=utf-8", false},
    [NAME_MODULE] = {"/photonlab.wasm", "photonlab.wasm", "application/wasm", false},
    [NAME_STUDENTS] = {"/students.wasm", NULL, "application/wasm", false},
    [NAME_STATE] = {"/state", NULL, "application/json", false},
    [NAME_FAULT] = {"/fault", NULL, NULL, true},
    [NAME_NEXT] = {"/next", NULL, NULL, true},
    [NAME_HINT] = {"/hint", NULL, NULL, true},
};

const char *server_file(Name name)
{
    return NAMED[name].file;
}

static enum MHD_Result answer(struct MHD_Connection *connection, unsigned status, const char *type, const char *bytes,
                              size_t size)
{
    static const char *const HEADERS[][2] = {
        {"Cache-Control", "no-store"},
        {"X-Content-Type-Options", "nosniff"},
        {"Referrer-Policy", "no-referrer"},
        {"Cross-Origin-Resource-Policy", "same-origin"},
        {"Cross-Origin-Opener-Policy", "same-origin"},
        // Scripts from this server alone: what students' code prints can never become one.
        {"Content-Security-Policy",
         "default-src 'none'; script-src 'self' 'wasm-unsafe-eval'; worker-src blob:; connect-src 'self'; style-src "
         "'unsafe-inline'; img-src data: blob:; form-action 'none'; base-uri 'none'; frame-ancestors 'none'"},
    };
    struct MHD_Response *response = MHD_create_response_from_buffer(size, (void *)bytes, MHD_RESPMEM_MUST_COPY);
    if (!response)
        return MHD_NO;
    for (size_t i = 0; i < sizeof HEADERS / sizeof *HEADERS; i++)
        MHD_add_response_header(response, HEADERS[i][0], HEADERS[i][1]);
    MHD_add_response_header(response, "Content-Type", type);
    enum MHD_Result result = MHD_queue_response(connection, status, response);
    MHD_destroy_response(response);
    return result;
}

static enum MHD_Result answer_text(struct MHD_Connection *connection, unsigned status, const char *text)
{
    return answer(connection, status, "text/plain; charset=utf-8", text, strlen(text));
}

static enum MHD_Result answer_state(Server *server, struct MHD_Connection *connection, Question *question)
{
    const char *after = MHD_lookup_connection_value(connection, MHD_GET_ARGUMENT_KIND, "after");
    if (after && atol(after) == server->tab->number && !question->waited) {
        Waiting *waiting = malloc(sizeof *waiting);
        if (!waiting)
            return MHD_NO;
        *waiting = (Waiting){server->waiting, connection, clock_seconds()};
        server->waiting = waiting;
        question->waited = true;
        MHD_suspend_connection(connection);
        return MHD_YES;
    }
    char *json = tab_state(server->tab);
    enum MHD_Result result =
        json ? answer(connection, MHD_HTTP_OK, NAMED[NAME_STATE].type, json, strlen(json)) : MHD_NO;
    free(json);
    return result;
}

static enum MHD_Result answer_name(Server *server, struct MHD_Connection *connection, Name name, Question *question)
{
    Tab *tab = server->tab;
    switch (name) {
    case NAME_PAGE:
    case NAME_SCRIPT:
    case NAME_MODULE:
        return answer(connection, MHD_HTTP_OK, NAMED[name].type, server->bytes[name], server->sizes[name]);
    case NAME_STUDENTS:
        return tab->bytes ? answer(connection, MHD_HTTP_OK, NAMED[name].type, tab->bytes, tab->size)
                          : answer_text(connection, MHD_HTTP_NOT_FOUND, "nothing is built yet\n");
    case NAME_STATE:
        return answer_state(server, connection, question);
    case NAME_FAULT:
        if (!tab_take_failure(tab, question->body))
            return answer_text(connection, MHD_HTTP_BAD_REQUEST, "expected: MODULE WHY RUN MEGABYTES OFFSET…\n");
        break;
    case NAME_NEXT:
        tab_next_step(tab);
        tab->number++;
        break;
    case NAME_HINT:
        coach_hint(&tab->coach);
        tab->number++;
        break;
    case NAMES:
        return MHD_NO;
    }
    return answer_text(connection, MHD_HTTP_OK, "");
}

enum MHD_Result server_answer(void *user, struct MHD_Connection *connection, const char *url, const char *method,
                              const char *version, const char *bytes, size_t *size, void **kept)
{
    Server *server = user;
    const char *path = "", *why = gate_refuses(&server->gate, connection, method, url, &path);
    Question *question = *kept;
    (void)version;
    if (why) {
        server_tell(server, why, question ? "" : url);
        return answer_text(connection, MHD_HTTP_FORBIDDEN, "refused; the terminal tells why\n");
    }
    if (!question) { // the headers are there, and more may come
        *kept = calloc(1, sizeof *question);
        return *kept ? MHD_YES : MHD_NO;
    }
    if (*size > 0) {
        size_t room = MOST_BODY - question->size, taken = *size < room ? *size : room;
        memcpy(question->body + question->size, bytes, taken);
        question->size += taken;
        if (*size > room) {
            server_tell(server, "it tells too much", path);
            return MHD_NO;
        }
        *size = 0;
        return MHD_YES;
    }
    const union MHD_ConnectionInfo *context = MHD_get_connection_info(connection, MHD_CONNECTION_INFO_SOCKET_CONTEXT);
    Visit *visit = context ? context->socket_context : NULL;
    if (visit) {
        visit->asked = true;
        visit->since = clock_seconds();
    }
    for (Name name = 0; name < NAMES; name++)
        if (strcmp(NAMED[name].path, path) == 0 && NAMED[name].tells == (strcmp(method, "POST") == 0))
            return answer_name(server, connection, name, question);
    server_tell(server, "there is nothing of this name", path);
    return answer_text(connection, MHD_HTTP_NOT_FOUND, "there is nothing of this name\n");
}

void server_answered(void *user, struct MHD_Connection *connection, void **kept, enum MHD_RequestTerminationCode code)
{
    const union MHD_ConnectionInfo *context = MHD_get_connection_info(connection, MHD_CONNECTION_INFO_SOCKET_CONTEXT);
    Visit *visit = context ? context->socket_context : NULL;
    (void)user, (void)code;
    free(*kept);
    *kept = NULL;
    if (!visit)
        return;
    visit->asked = false;
    visit->since = clock_seconds();
}
