#include "preview/snapshot.h"
#include "preview/window.h"

#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

bool snapshot_write(Canvas *canvas, const char *path, Error *error)
{
    int width = canvas_width(canvas), height = canvas_height(canvas);
    size_t count = (size_t)width * (size_t)height;
    uint8_t *bytes = malloc(count * 4);
    Image image;
    if (!bytes || !image_create(&image, width, height, error)) {
        free(bytes);
        return error_set(error, "not enough memory for a picture of %d x %d", width, height);
    }
    canvas_read(canvas, bytes);
    for (size_t i = 0; i < count; i++) // the canvas holds sRGB, an Image linear light
        image.pixels[i] =
            colour(srgb_decode((float)bytes[4 * i] / 255.0f), srgb_decode((float)bytes[4 * i + 1] / 255.0f),
                   srgb_decode((float)bytes[4 * i + 2] / 255.0f));
    bool ok = image_write(&image, path, error);
    image_free(&image);
    free(bytes);
    return ok;
}

void session_draw(const Session *session, Canvas *canvas, const View *view, bool bare)
{
    static const char *const help = "1 2 3 4 5   points, paths, lobe, screen, tree\n"
                                    "c           colour by power, photon, bounce, material\n"
                                    "b           the reference beside yours\n"
                                    "arrows      paths: photon, bounce. lobe: angle, exponent\n"
                                    "            screen: surface. tree: depth\n"
                                    "d           lobe: glossy or diffuse step\n"
                                    "mouse       left: turn. right: move. wheel: near, far\n"
                                    "f           frame the scene    0  the scene's camera\n"
                                    "space       slow light: photons in order of flight\n"
                                    "+ -         more, fewer photons    r  another seed\n"
                                    "p           render what you see, by your code\n"
                                    "w           wireframe    s  snapshot    o  report\n"
                                    "h           this list    q, esc  quit";
    char status[700], banner[2000];
    session_status(session, status, sizeof status);
    session_banner(session, banner, sizeof banner);
    Captions captions = {.help = help, .left_title = "yours", .right_title = "reference"};
    captions.status = bare || session->options->given ? NULL : status;
    captions.banner = bare || !banner[0] ? NULL : banner;
    captions.bare = bare;
    int passes;
    const Image *image = session->render ? run_image(session->render, &passes) : NULL;
    uint8_t *picture = image ? malloc((size_t)image->width * (size_t)image->height * 4) : NULL;
    if (picture) {
        for (size_t i = 0; i < (size_t)image->width * (size_t)image->height; i++)
            for (int c = 0; c < 4; c++)
                picture[4 * i + (size_t)c] =
                    c == 3 ? 255 : (uint8_t)(255.0f * srgb_encode(colour_channel(image->pixels[i], c)) + 0.5f);
        captions.picture = picture;
        captions.picture_columns = image->width;
        captions.picture_rows = image->height;
    }
    view_draw(canvas, session->scene, view, session_yours(session), session->sides[REFERENCE], &captions);
    free(picture);
}

// snprintf at the end of what is there; cut off where there is no room.
static void append(char *text, size_t size, const char *format, ...)
{
    size_t length = strlen(text);
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(text + length, size - length, format, arguments);
    va_end(arguments);
}

static void append_view(const View *view, char *text, size_t size)
{
    append(text, size, " --view %s --colour %s", view_kind_name(view->kind), colour_mode_name(view->colour));
    const Framing *framing = &view->framing;
    if (view->kind == VIEW_LOBE)
        append(text, size, " --exponent %g --angle %g%s", (double)view->exponent, (double)view->angle,
               view->diffuse ? " --diffuse" : "");
    if (view->kind == VIEW_PATHS && view->path >= 0)
        append(text, size, " --path %ld", view->path);
    if (view->kind == VIEW_PATHS && view->bounce >= 0)
        append(text, size, " --bounce %d", view->bounce);
    if (view->kind == VIEW_SCREEN && view->surface >= 0)
        append(text, size, " --surface %d", view->surface);
    if (view->kind == VIEW_TREE)
        append(text, size, " --level %d", view->level);
    if (view_is_framed(view) && (framing->zoom != 1.0f || framing->right != 0.0f || framing->up != 0.0f))
        append(text, size, " --framing %.4g,%.4g,%.4g", (double)framing->zoom, (double)framing->right,
               (double)framing->up);
    if (view->flight >= 0.0)
        append(text, size, " --flight %.4g", view->flight);
    if (view->split)
        append(text, size, " --split");
    if (!view->wireframe)
        append(text, size, " --no-wireframe");
}

void snapshot_command(const PreviewOptions *options, const View *view, const Session *session, int width, int height,
                      char *text, size_t size)
{
    Camera camera = orbit_camera(&view->orbit);
    Vec3 p = camera.position, t = view->orbit.target;
    snprintf(text, size,
             "build/photonlab preview %s --snapshot %s --size %dx%d --photons %ld --seed %llu "
             "--camera %.5g,%.5g,%.5g,%.5g,%.5g,%.5g",
             options->scene_path, options->snapshot, width, height, session->photons, (unsigned long long)session->seed,
             (double)p.x, (double)p.y, (double)p.z, (double)t.x, (double)t.y, (double)t.z);
    append_view(view, text, size);
    if (options->code)
        append(text, size, " --code %s", options->code);
    if (options->play_is_given) {
        append(text, size, " --steps ");
        step_choice_print(options->play, text + strlen(text), size - strlen(text));
    }
}

// Where a snapshot is drawn: without a display, or in a window that is not shown.
typedef struct {
    Context *context;
    Window *window;
    Canvas *canvas;
} Easel;

static bool easel_open(Easel *easel, const PreviewOptions *options, Error *error)
{
    *easel = (Easel){NULL, NULL, NULL};
    GlLoader loader;
    if (options->hidden_context_is_window) {
        if (!(easel->window = window_create_hidden(options->width, options->height, error)))
            return false;
        loader = window_loader(easel->window);
    } else {
        if (!(easel->context = context_create(options->context, error)))
            return false;
        loader = context_loader(easel->context);
    }
    easel->canvas = canvas_create(loader, options->width, options->height, error);
    return easel->canvas != NULL;
}

static void easel_close(Easel *easel)
{
    if (easel->canvas)
        canvas_free(easel->canvas);
    if (easel->context)
        context_free(easel->context);
    if (easel->window)
        window_free(easel->window);
}

static void show_given(Session *session, const PreviewOptions *options)
{
    side_set_recording(session->sides[YOURS], *options->given);
    *options->given = (Recording){.photons = NULL};
    if (options->given_reference) {
        side_set_recording(session->sides[REFERENCE], *options->given_reference);
        *options->given_reference = (Recording){.photons = NULL};
    }
}

// Waits until everything that the view needs is there.
static void settle(Session *session, const View *view)
{
    while (session_poll(session, view) || session_is_busy(session))
        session_wait(session, 0.05);
}

bool preview_snapshot(const Scene *scene, const PreviewOptions *options, Broker *broker, Error *error)
{
    Easel easel;
    Session session = {.photons = 0};
    bool ok = easel_open(&easel, options, error);
    if (ok && (ok = session_start(&session, scene, options, broker, easel.canvas, error))) {
        if (options->given) {
            show_given(&session, options);
        } else {
            session_ask_photons(&session, &options->view);
            settle(&session, &options->view);
        }
        if (session.fault[0])
            ok = error_set(error, "%s", session.fault);
        else
            session_draw(&session, easel.canvas, &options->view, options->bare);
    }
    ok = ok && snapshot_write(easel.canvas, options->snapshot, error);
    session_end(&session);
    easel_close(&easel);
    return ok;
}

bool preview_snapshots(const Scene *scene, const PreviewOptions *options, Broker *broker, Error *error)
{
    Easel easel;
    Session session = {.photons = 0};
    bool ok =
        easel_open(&easel, options, error) && session_start(&session, scene, options, broker, easel.canvas, error);
    if (ok)
        session_ask_photons(&session, &options->view);
    while (ok) {
        bool news = session_poll(&session, &options->view);
        if (news && !session_is_busy(&session)) {
            session_draw(&session, easel.canvas, &options->view, options->bare);
            if (snapshot_write(easel.canvas, options->snapshot, error))
                printf("%s is new\n", options->snapshot);
            else
                printf("%s\n", error->message); // the next save may fare better
            fflush(stdout);
        }
        session_wait(&session, 0.2);
    }
    session_end(&session);
    easel_close(&easel);
    return ok;
}
