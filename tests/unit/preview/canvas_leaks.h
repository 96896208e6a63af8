// For programs that open a context: one file of each includes this.
#ifndef PHOTONLAB_TESTS_CANVAS_LEAKS_H
#define PHOTONLAB_TESTS_CANVAS_LEAKS_H

// Mesa keeps some hundred bytes of each context for ever. Read by AddressSanitizer, where there is one.
const char *__lsan_default_suppressions(void);
const char *__lsan_default_suppressions(void)
{
    return "leak:libOSMesa\nleak:libEGL\nleak:libLLVM\nleak:_dri.so\nleak:libgallium\n";
}

#endif
