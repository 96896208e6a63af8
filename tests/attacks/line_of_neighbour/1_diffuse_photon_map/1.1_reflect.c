// A compiler that complains shows the line in question, of whatever file it is told that it reads.
#line 1 "@WORK@/neighbour/1.1_reflect.c"
nobody knows this;
another unknown;
