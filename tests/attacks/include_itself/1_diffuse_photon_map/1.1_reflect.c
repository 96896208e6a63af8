// A compiler that is kept busy.
#include __FILE__
#include __FILE__
