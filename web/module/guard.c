// What is linked around a student's objects only: it ends a run that hangs or wants too much memory, in the midst of it, so that
// the stack tells where that was. Compiled with -fsanitize-coverage=trace-pc, their code calls this wherever it goes.
#include "web/module/web.h"

#include "base/parallel.h"

#define LOOK_EVERY 65536u // calls
// Fewer since it was heard of: it may not have got a processor, and is given thrice the time.
#define BUSY 2000000u

typedef enum { STOP_LOOP, STOP_MEMORY, STOP_NULL, STOP_BOUNDS } Stop; // as photonlab.js has them
_Noreturn void IMPORT(photonlab_stop)(Stop why);

static double heard, patience; // clock_seconds(), s
static unsigned calls;         // since then

void web_alive(double given)
{
    heard = clock_seconds();
    patience = given;
    calls = 0;
}

void __sanitizer_cov_trace_pc(void)
{
    if (++calls % LOOK_EVERY == 0 && clock_seconds() - heard > (calls < BUSY ? 3.0 * patience : patience))
        photonlab_stop(STOP_LOOP);
}

// -fsanitize=null,bounds -fsanitize-minimal-runtime calls these; since the compiler thinks that they may return, it does not put the
// calls of several lines into one.
void __ubsan_handle_type_mismatch_minimal(void)
{
    photonlab_stop(STOP_NULL);
}

void __ubsan_handle_out_of_bounds_minimal(void)
{
    photonlab_stop(STOP_BOUNDS);
}

// Linked with --wrap: where there is no memory, none of the code goes on with a null pointer, which may be written to here.
#define WRAP(function, parameters, arguments, wanted)                                                                  \
    void *__real_##function parameters;                                                                                \
    void *__wrap_##function parameters                                                                                 \
    {                                                                                                                  \
        void *memory = __real_##function arguments;                                                                    \
        if (!memory && (wanted) > 0)                                                                                   \
            photonlab_stop(STOP_MEMORY);                                                                               \
        return memory;                                                                                                 \
    }
WRAP(malloc, (size_t size), (size), size)
WRAP(calloc, (size_t count, size_t size), (count, size), count *size)
WRAP(realloc, (void *old, size_t size), (old, size), size)
