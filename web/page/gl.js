// The functions of lib/preview/draw/canvas_internal.h by WebGL 2, and what draws: what the module imports. OpenGL names its
// objects by numbers, which count up from 1 here, and points into memory, which is the module's.

function photonlabGl(gl, memory) {
    const objects = [null] // by number
    const bytes = () => new Uint8Array(memory().buffer)
    const words = () => new Int32Array(memory().buffer)
    const text = at => {
        const all = bytes()
        return new TextDecoder().decode(all.slice(at, all.indexOf(0, at)))
    }
    const putText = (string, most, at) => {
        const encoded = new TextEncoder().encode(string).slice(0, most - 1)
        bytes().set(encoded, at)
        bytes()[at + encoded.length] = 0
    }
    const add = object => objects.push(object) - 1
    const create = make => (count, at) => {
        for (let i = 0; i < count; i++) words()[(at >> 2) + i] = add(make.call(gl))
    }
    const remove = take => (count, at) => {
        for (let i = 0; i < count; i++) {
            const number = words()[(at >> 2) + i]
            if (number) take.call(gl, objects[number])
            if (number) objects[number] = null
        }
    }
    const bind = call => (target, number) => call.call(gl, target, objects[number])
    const MULTISAMPLE = 0x809d, MAJOR_VERSION = 0x821b, MINOR_VERSION = 0x821c // that WebGL does not know
    let pointSize = null // the present program's uniform

    // What draws, by its name: Chromium tells it by an extension, Firefox in the place of its own.
    const renderer = () => {
        const own = gl.getParameter(gl.RENDERER), told = /^WebKit/.test(own) && gl.getExtension('WEBGL_debug_renderer_info')
        return told ? gl.getParameter(told.UNMASKED_RENDERER_WEBGL) : own
    }

    return {
        photonlab_software: () => /SwiftShader|llvmpipe|softpipe|software|Basic Render/i.test(renderer()),
        glAttachShader: (program, shader) => gl.attachShader(objects[program], objects[shader]),
        glBindBuffer: bind(gl.bindBuffer),
        glBindFramebuffer: bind(gl.bindFramebuffer),
        glBindRenderbuffer: bind(gl.bindRenderbuffer),
        glBindTexture: bind(gl.bindTexture),
        glBindVertexArray: number => gl.bindVertexArray(objects[number]),
        glBlendFuncSeparate: (a, b, c, d) => gl.blendFuncSeparate(a, b, c, d),
        glBlitFramebuffer: (...numbers) => gl.blitFramebuffer(...numbers),
        // A length of 0 would be taken for all that memory holds.
        glBufferData: (target, size, at, use) => size ? gl.bufferData(target, bytes(), use, at, size) : gl.bufferData(target, 0, use),
        glCheckFramebufferStatus: target => gl.checkFramebufferStatus(target),
        glClear: mask => gl.clear(mask),
        glClearColor: (r, g, b, a) => gl.clearColor(r, g, b, a),
        glCompileShader: shader => gl.compileShader(objects[shader]),
        glCreateProgram: () => add(gl.createProgram()),
        glCreateShader: kind => add(gl.createShader(kind)),
        glDeleteBuffers: remove(gl.deleteBuffer),
        glDeleteFramebuffers: remove(gl.deleteFramebuffer),
        glDeleteProgram: program => gl.deleteProgram(objects[program]),
        glDeleteRenderbuffers: remove(gl.deleteRenderbuffer),
        glDeleteShader: shader => gl.deleteShader(objects[shader]),
        glDeleteTextures: remove(gl.deleteTexture),
        glDeleteVertexArrays: remove(gl.deleteVertexArray),
        glDisable: what => what === MULTISAMPLE || gl.disable(what),
        glDrawArrays: (kind, first, count) => gl.drawArrays(kind, first, count),
        glEnable: what => gl.enable(what),
        glEnableVertexAttribArray: place => gl.enableVertexAttribArray(place),
        glFinish: () => gl.finish(),
        glFramebufferRenderbuffer: (target, at, kind, number) =>
            gl.framebufferRenderbuffer(target, at, kind, objects[number]),
        glFramebufferTexture2D: (target, at, kind, number, level) =>
            gl.framebufferTexture2D(target, at, kind, objects[number], level),
        glGenBuffers: create(gl.createBuffer),
        glGenFramebuffers: create(gl.createFramebuffer),
        glGenRenderbuffers: create(gl.createRenderbuffer),
        glGenTextures: create(gl.createTexture),
        glGenVertexArrays: create(gl.createVertexArray),
        glGetError: () => (gl.isContextLost() ? 0 : gl.getError()), // of a lost context there is no end of errors
        // WebGL 2 has all of OpenGL 3.3 that the canvas uses.
        glGetIntegerv: (what, at) => {
            words()[at >> 2] = what === MAJOR_VERSION || what === MINOR_VERSION ? 3 : gl.getParameter(what)
        },
        glGetProgramInfoLog: (program, most, length, at) => putText(gl.getProgramInfoLog(objects[program]) || '', most, at),
        glGetProgramiv: (program, what, at) => {
            words()[at >> 2] = gl.getProgramParameter(objects[program], what)
        },
        glGetString: () => 0,
        glGetUniformLocation: (program, at) => add(gl.getUniformLocation(objects[program], text(at))),
        glLinkProgram: program => gl.linkProgram(objects[program]),
        glPixelStorei: (what, value) => gl.pixelStorei(what, value),
        glPointSize: size => gl.uniform1f(pointSize, size),
        glReadPixels: (x, y, width, height, format, type, at) =>
            gl.readPixels(x, y, width, height, format, type, bytes(), at),
        glRenderbufferStorage: (target, format, width, height) => gl.renderbufferStorage(target, format, width, height),
        glScissor: (x, y, width, height) => gl.scissor(x, y, width, height),
        glShaderSource: (shader, count, at) => {
            let source = ''
            for (let i = 0; i < count; i++) source += text(words()[(at >> 2) + i])
            gl.shaderSource(objects[shader], source)
        },
        glTexImage2D: (target, level, inside, width, height, border, format, type, at) =>
            gl.texImage2D(target, level, inside, width, height, border, format, type, bytes(), at),
        glTexParameteri: (target, name, value) => gl.texParameteri(target, name, value),
        glUniform1f: (place, value) => gl.uniform1f(objects[place], value),
        glUniformMatrix4fv: (place, count, turned, at) =>
            gl.uniformMatrix4fv(objects[place], turned, new Float32Array(memory().buffer, at, 16 * count)),
        glUseProgram: program => {
            gl.useProgram(objects[program])
            pointSize = gl.getUniformLocation(objects[program], 'point_size')
        },
        glVertexAttribPointer: (place, size, type, scaled, stride, at) =>
            gl.vertexAttribPointer(place, size, type, scaled, stride, at),
        glViewport: (x, y, width, height) => gl.viewport(x, y, width, height),
    }
}
