// Pictures of the preview in files.
#include "preview/session.h"
#include "base/text.h"
#include "preview/window.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

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

// The flags of the present view's settings, of those that are chosen.
static void append_settings(const View *view, char *text, size_t size)
{
    const ViewSetting *settings = view_type(view)->settings;
    const double *values = view->settings[view->kind];
    for (int i = 0; i < MOST_SETTINGS && settings[i].flag; i++) {
        if (settings[i].kind == SETTING_SWITCH && values[i] != 0.0)
            text_append(text, size, " --%s", settings[i].flag);
        else if (settings[i].kind == SETTING_NUMBER)
            text_append(text, size, " --%s %g", settings[i].flag, values[i]);
        else if (settings[i].kind == SETTING_WHOLE && values[i] >= settings[i].low)
            text_append(text, size, " --%s %.0f", settings[i].flag, values[i]);
    }
}

// How the picture was rendered, if it is one.
static void append_render(const Session *session, char *text, size_t size)
{
    int passes = 0;
    const RunRequest *asked = &session->asked;
    const Run *render = session->runs[RUN_RENDER][YOURS];
    if (!render || !run_image(render, &passes))
        return;
    text_append(text, size, " --render %d --integrator %s", passes > 0 ? passes : 1,
                integrator_names[asked->integrator]);
    if (asked->radii != RADII_ALIKE)
        text_append(text, size, " --radii %s", radii_rules[asked->radii]);
}

void snapshot_command(const Session *session, char *text, size_t size)
{
    const PreviewOptions *options = session->options;
    const View *view = session->view;
    const Framing *framing = &view->framing;
    Vec3 p = orbit_camera(&view->orbit).position, t = view->orbit.target;
    text[0] = '\0';
    text_append(text, size, "build/photonlab preview %s --snapshot %s --size %dx%d --photons %ld --seed %llu",
                session->scene_path, options->snapshot, canvas_width(session->canvas), canvas_height(session->canvas),
                session->asked.photons, (unsigned long long)session->asked.seed);
    text_append(text, size, " --camera %.5g,%.5g,%.5g,%.5g,%.5g,%.5g", (double)p.x, (double)p.y, (double)p.z,
                (double)t.x, (double)t.y, (double)t.z);
    text_append(text, size, " --view %s --colour %s", view_names[view->kind], colour_names[view->colour]);
    append_settings(view, text, size);
    if (view_type(view)->place != IN_THE_SCENE &&
        (framing->zoom != 1.0f || framing->right != 0.0f || framing->up != 0.0f))
        text_append(text, size, " --framing %.4g,%.4g,%.4g", (double)framing->zoom, (double)framing->right,
                    (double)framing->up);
    if (view->flight >= 0.0)
        text_append(text, size, " --flight %.4g", view->flight);
    if (view->exposure != 0.0f)
        text_append(text, size, " --exposure %g", (double)view->exposure);
    if (view->split)
        text_append(text, size, " --split");
    if (!view->wireframe)
        text_append(text, size, " --no-wireframe");
    if (options->code)
        text_append(text, size, " --code %s", options->code);
    if (session->asked.spectral)
        text_append(text, size, " --spectral");
    append_render(session, text, size);
    if (options->play_is_given) {
        text_append(text, size, " --steps ");
        step_choice_print(options->play, text + strlen(text), size - strlen(text));
    }
}

// Draws what is there, when everything that the view needs is.
static bool draw_and_write(Session *session, const Scene *scene, Error *error)
{
    const PreviewOptions *options = session->options;
    for (int i = 0; i < PLAYERS; i++) {
        Recording recording;
        if (options->given[i] && !recording_read(options->given[i], scene, &recording, error))
            return false;
        if (options->given[i])
            view_data_record(session->data[i], recording);
    }
    session->asked.passes = options->render;
    if (options->render > 0 && !session->runs[RUN_RENDER][YOURS])
        session_render(session);
    while (!options->given[YOURS] && (session_poll(session) || session_is_busy(session)))
        session_wait(session, 0.05);
    if (session->fault[0] && !options->every_save)
        return error_set(error, "%s", session->fault);
    session_draw(session, session->view, NULL);
    return snapshot_write(session->canvas, options->snapshot, error);
}

bool preview_snapshot(const Scene *scene, const PreviewOptions *options, Broker *broker, Error *error)
{
    Session session = {.canvas = NULL};
    Window *window = options->in_window ? window_create(NULL, options->width, options->height, error) : NULL;
    Context *context = options->in_window ? NULL : context_create(options->context, error);
    Canvas *canvas = window || context ? canvas_create(window ? window_loader() : context_loader(context),
                                                       options->width, options->height, error)
                                       : NULL;
    bool ok = canvas && session_start(&session, scene, options, &options->view, broker, canvas, error);
    if (ok && !options->every_save)
        ok = draw_and_write(&session, scene, error);
    while (ok && options->every_save) {
        if (draw_and_write(&session, scene, error))
            printf("%s is new\n", options->snapshot);
        else
            puts(error->message); // the next save may fare better
        while (!session_poll(&session))
            session_wait(&session, 0.2);
    }
    session_end(&session);
    canvas_free(canvas);
    context_free(context);
    window_free(window);
    return ok;
}
