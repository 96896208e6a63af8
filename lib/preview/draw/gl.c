#include "preview/draw/gl.h"

#include <string.h>

bool gl_load(Gl *gl, GlLoader loader, Error *error)
{
    void *address;
#define LOAD(name)                                                                                                     \
    if (!(address = loader("gl" #name)))                                                                               \
        return error_set(error, "this OpenGL has no gl" #name "; the preview needs OpenGL 3.3");                       \
    memcpy(&gl->name, &address, sizeof address); // C99 has no cast to a function
    GL_FUNCTIONS(LOAD)
#undef LOAD
    int major = 0, minor = 0;
    gl->GetIntegerv(GL_MAJOR_VERSION, &major);
    gl->GetIntegerv(GL_MINOR_VERSION, &minor);
    if (10 * major + minor >= 33)
        return true;
    const unsigned char *version = gl->GetString(GL_VERSION);
    return error_set(error, "this is OpenGL %s; the preview needs 3.3",
                     version ? (const char *)version : "without a context");
}

// WebGL 2 is OpenGL ES 3.0: its shaders differ in their first lines only.
#ifdef __wasm__
static const char HEADER[] = "#version 300 es\nprecision highp float;\n";
#else
static const char HEADER[] = "#version 330 core\n";
#endif

unsigned gl_program(const Gl *gl, const char *vertex_shader, const char *fragment_shader, Error *error)
{
    unsigned program = gl->CreateProgram();
    for (int i = 0; i < 2; i++) {
        unsigned shader = gl->CreateShader(i == 0 ? GL_VERTEX_SHADER : GL_FRAGMENT_SHADER);
        gl->ShaderSource(shader, 2, (const char *const[]){HEADER, i == 0 ? vertex_shader : fragment_shader}, NULL);
        gl->CompileShader(shader);
        gl->AttachShader(program, shader);
        gl->DeleteShader(shader); // when the program goes
    }
    gl->LinkProgram(program);
    int linked = 0;
    gl->GetProgramiv(program, GL_LINK_STATUS, &linked);
    if (linked)
        return program;
    char log[400] = "";
    gl->GetProgramInfoLog(program, sizeof log, NULL, log);
    gl->DeleteProgram(program);
    error_set(error, "OpenGL does not take the preview's shaders: %s", log);
    return 0;
}
