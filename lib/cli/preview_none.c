// In the place of preview.c and frame.c, whose letters are the preview's, where the Makefile finds no headers for it.
#include "cli/cli.h"

#include <stdio.h>

int command_preview(int count, char **arguments)
{
    (void)count, (void)arguments;
    fputs("this program was built without GLFW; Debian, Ubuntu: apt-get install libglfw3-dev; Fedora: dnf install "
          "glfw-devel; Arch: pacman -S glfw; macOS: brew install glfw; then make clean, make\n",
          stderr);
    return EXIT_INPUT;
}

int command_frame(int count, char **arguments)
{
    return command_preview(count, arguments);
}
