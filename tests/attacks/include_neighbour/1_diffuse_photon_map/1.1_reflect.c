// Another's work, which lies where it can be found.
#include "@WORK@/neighbour/1.1_reflect.c"
