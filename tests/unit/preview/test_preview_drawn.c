// What the views look like, drawn without a display.
#include "unit/preview/canvas_helpers.h"
#include "unit/preview/view_helpers.h"

static double mean_brightness(Canvas *canvas)
{
    size_t count = (size_t)canvas_width(canvas) * (size_t)canvas_height(canvas);
    uint8_t *bytes = memory(count, 4);
    canvas_read(canvas, bytes);
    double sum = 0;
    for (size_t i = 0; i < count; i++)
        sum += (double)bytes[4 * i] + (double)bytes[4 * i + 1] + (double)bytes[4 * i + 2] - 30.0; // over the background
    return sum / (double)count / 3.0;
}

// In the panel's corner: the plate behind a fault is red, and grey while the next build runs.
static void check_plate(Canvas *canvas, const View *view, ViewData *data, Captions *captions)
{
    size_t at = 4 * (6 * (size_t)canvas_width(canvas) + (size_t)view_area(canvas, view).width + 2);
    uint8_t *bytes = memory((size_t)canvas_width(canvas) * (size_t)canvas_height(canvas), 4);
    for (int old = 0; old < 2; old++) {
        captions->banner_is_old = old;
        view_draw(canvas, view, data, NULL, captions);
        canvas_read(canvas, bytes);
        int redder = bytes[at] - bytes[at + 2];
        assert_true(old ? abs(redder) < 20 && bytes[at] > 40 : redder > 60);
    }
}

// Pixel by pixel, each step has a place in the panel, and none has one over the picture.
static void check_places(Canvas *canvas, const View *view)
{
    bool met[STEP_COUNT] = {false};
    int width = view_area(canvas, view).width, count = 0;
    for (int y = 0; y < canvas_height(canvas); y++)
        for (int x = 0; x < canvas_width(canvas); x++) {
            int step = panel_step_at(canvas, view, (float)x, (float)y);
            assert_true(step < STEP_COUNT && (step < 0 || x >= width));
            count += step >= 0 && !met[step];
            met[step < 0 ? 0 : step] |= step >= 0;
        }
    assert_int_equal(count, STEP_COUNT);
}

// Every view at the smallest size; points as bright whether a tenth or all of them is drawn.
TEST(every_view_draws)
{
    start(state);
    if (!context)
        skip();
    Canvas *canvas = canvas_create(context_loader(context), 400, 300, &said);
    assert_non_null(canvas);
    Scene *scene = scene_from_file("scenes/box_diffuse.yaml");
    ViewData *data = view_data_create(canvas, scene), *empty = view_data_create(canvas, scene);
    assert_true(data && empty);
    View view = view_default(scene);
    Captions captions = {.help = "keys", .status = "status"};
    view_draw(canvas, &view, empty, NULL, &captions); // nothing is there yet
    view_data_record(data, recording_of(scene, 100000));
    view.wireframe = false;
    view.panel = 0;
    view_draw(canvas, &view, data, NULL, &captions);
    double all = mean_brightness(canvas);
    view.most_points = view_data_recording(data)->count / 10;
    view_draw(canvas, &view, data, NULL, &captions);
    double part = mean_brightness(canvas);
    assert_true(all > 8 && part / all > 0.6 && part / all < 1.6);
    view.flight = 1.0; // a tenth of them
    view.most_points = 0;
    view_draw(canvas, &view, data, NULL, &captions);
    assert_true(mean_brightness(canvas) < 0.3 * all);
    view.flight = -1;
    view.panel = 20;
    captions.banner = "1.3_scatter_diffuse.c:14: scatter_diffuse: segmentation fault, wrapped because it is long";
    check_plate(canvas, &view, data, &captions);
    check_places(canvas, &view);
    view.wireframe = view.split = view.help = true;
    for (int kind = 0; kind < VIEW_COUNT; kind++)
        for (int colour = 0; colour < COLOUR_COUNT; colour++) {
            view.kind = (ViewKind)kind;
            view.colour = (ColourMode)colour;
            view_draw(canvas, &view, data, empty, &captions);
            char text[256] = "";
            view_type(&view)->describe(&view, data, text, sizeof text);
            assert_true(strlen(text) > 10);
        }
    view_data_free(data);
    view_data_free(empty);
    canvas_free(canvas);
    end(state);
}
