// In the place of preview.c and frame.c, whose letters are the preview's, where the Makefile finds no headers for it.
#include "cli/cli.h"

#include <stdio.h>

static bool refuse(void)
{
    fputs("this program was built without GLFW; Debian, Ubuntu: apt-get install libglfw3-dev; Fedora: dnf install "
          "glfw-devel; Arch: pacman -S glfw; macOS: brew install glfw; then make clean, make\n",
          stderr);
    return false;
}

const Command command_preview = {.words = "a window on the photons, live; or a snapshot of it",
                                 .line = {.command = "photonlab preview"},
                                 .prepare = refuse};
const Command command_frame = {
    .words = "a frame with words about a picture", .line = {.command = "photonlab frame"}, .prepare = refuse};
