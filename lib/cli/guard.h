// A command that plays students' code works in a process of its own: where that crashes or never ends, the other one says in
// which step and line.
#ifndef PHOTONLAB_CLI_GUARD_H
#define PHOTONLAB_CLI_GUARD_H

// Splits the program in two, before there are threads or scenes. Returns in the one that works; the other waits, explains and
// ends with the same exit code, or EXIT_INPUT. `code`: the folder of the objects; NULL: nothing happens. `threads`: as for
// parallel_threads, how many will work. Where no process can be had, the work goes on unguarded.
void guard_begin(const char *code, int threads);

// A sign of life from the work: a part of it is done.
void guard_alive(void);

#endif
