// Has the compiler print other people's files as errors.
#include "/etc/shadow"
#include "/etc/passwd"
#include "/proc/1/environ"
