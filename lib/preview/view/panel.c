// The column of words beside the picture: what is wrong, how the steps are, what is shown and what its colours mean, and at its end
// what the preview is busy with.
#include "preview/view/view_internal.h"

#include "base/text.h"

#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define MARGIN 0.6f // ems

static const Rgba PLATE = {14, 18, 27, 255};
static const Rgba DIM = {140, 150, 168, 255};
static const Rgba INKS[VERDICT_STATES] = {[VERDICT_PASS] = {120, 220, 130, 255},
                                          [VERDICT_FAIL] = {255, 120, 105, 255},
                                          [VERDICT_ERROR] = {255, 120, 105, 255}};

// Where the next words go; pixels.
typedef struct {
    Canvas *canvas;
    float left, width, y, bottom, line, scale; // `line`: its height
} Column;

// Wrapped into the column, in at most so many lines, as far as there is room. `plate` behind it: none where its alpha is 0.
static void write_on_plate(Column *column, Rgba ink, Rgba plate, int most, const char *text)
{
    char wrapped[2400];
    int room = (int)((column->bottom - column->y) / column->line);
    if (!text[0] || room < 1)
        return;
    int lines = overlay_wrap(text, column->scale, column->width, most < room ? most : room, wrapped, sizeof wrapped);
    float margin = MARGIN * EM * column->scale, height = (float)lines * column->line;
    if (plate.a > 0)
        canvas_rectangle(column->canvas, column->left - margin, column->y - 0.5f * margin,
                         column->width + 2.0f * margin, height + margin, plate);
    canvas_text(column->canvas, column->left, column->y, column->scale, ink, wrapped);
    column->y += height + (plate.a > 0 ? margin : 0.0f);
}

static void PRINTF_LIKE(4, 5) write_words(Column *column, Rgba ink, int most, const char *format, ...)
{
    char text[1200];
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(text, sizeof text, format, arguments);
    va_end(arguments);
    write_on_plate(column, ink, (Rgba){0, 0, 0, 0}, most, text);
}

static void write_legend(Column *column, const View *view, const ViewData *data)
{
    Legend legend = {.count = 0};
    if (view_type(view)->legend)
        view_type(view)->legend(view, data, &legend);
    for (int i = 0; i < legend.count && column->y + column->line < column->bottom; i++) {
        float side = 0.62f * EM * column->scale;
        Rgba colour = legend.entries[i].colour;
        colour.a = 255;
        canvas_rectangle(column->canvas, column->left, column->y + 0.35f * EM * column->scale, side, side, colour);
        canvas_text(column->canvas, column->left + 1.6f * side, column->y, column->scale, COLOUR_OF_TEXT,
                    legend.entries[i].text);
        column->y += column->line;
    }
}

#define MOST_IN_STAGE 6

// The column's place on the canvas.
static Column column_of(Canvas *canvas, const View *view)
{
    float left = (float)view_area(canvas, view).width, scale = view_scale(canvas, view), margin = MARGIN * EM * scale;
    float width = (float)canvas_width(canvas) - left, height = (float)canvas_height(canvas);
    return (Column){canvas, left + margin, width - 2.0f * margin, margin, height - 0.5f * margin, LINE_HEIGHT * scale,
                    scale};
}

// Of the steps of its stage, from 0: that of 1.3 is 2.
static int place_in_stage(const StepInfo *step)
{
    return atoi(strchr(step->id, '.') + 1) - 1;
}

int panel_step_at(Canvas *canvas, const View *view, float x, float y)
{
    Column column = column_of(canvas, view);
    float place = floorf(MOST_IN_STAGE * (x - column.left) / column.width);
    float row = floorf((y - column.y) / column.line);
    for (int i = 0; i < STEP_COUNT && view->panel > 0.0f; i++)
        if (row == (float)(step_table[i].stage - step_table[0].stage) && place == (float)place_in_stage(&step_table[i]))
            return i;
    return -1;
}

// A mark for each step, a line a stage.
static void write_marks(Column *column, const Verdicts *verdicts)
{
    float cell = column->width / MOST_IN_STAGE;
    for (size_t i = 0; i < verdicts->count; i++) {
        const Verdict *verdict = &verdicts->steps[i];
        int place = place_in_stage(&step_table[i]);
        if (i > 0 && place == 0)
            column->y += column->line;
        Rgba ink = verdict->old || INKS[verdict->state].a == 0 ? DIM : INKS[verdict->state];
        float x = column->left + cell * (float)place;
        char text[24];
        snprintf(text, sizeof text, "%s %s%s", step_table[i].id, verdict_marks[verdict->state],
                 verdict->judged_now ? ".." : "");
        if (i == verdicts->present)
            canvas_rectangle(column->canvas, x - 3.0f, column->y, cell - 2.0f, column->line, (Rgba){48, 60, 84, 255});
        canvas_text(column->canvas, x, column->y, column->scale, ink, text);
    }
    column->y += 1.5f * column->line;
}

static void write_verdict(Column *column, const Verdict *verdict)
{
    bool wrong = verdict->state == VERDICT_FAIL || verdict->state == VERDICT_ERROR;
    Rgba ink = verdict->old ? DIM : COLOUR_OF_TEXT;
    if (verdict->state == VERDICT_TODO && !verdict->judged_now)
        write_words(column, DIM, 2, "not started: take away the line with todo(), and write");
    if (wrong || verdict->state == VERDICT_SKIP)
        write_words(column, ink, 9, "%s", verdict->message);
    if (wrong && !strstr(verdict->message, verdict->where))
        write_words(column, DIM, 2, "in %s", verdict->where);
    if (verdict->looks_like[0])
        write_words(column, verdict->old ? DIM : (Rgba){255, 214, 120, 255}, 5, "looks like: %s", verdict->looks_like);
    if (verdict->judged_now)
        write_words(column, DIM, 1, "being judged ..");
}

// The present step in words.
static void write_step(Column *column, const Captions *captions)
{
    const Verdicts *verdicts = captions->verdicts;
    const StepInfo *step = &step_table[verdicts->present], *next = &step_table[verdicts_next(verdicts)];
    const Verdict *verdict = &verdicts->steps[verdicts->present];
    write_words(column, COLOUR_OF_TEXT, 2, "%s %s %s", verdict_marks[verdict->state], step->id, step->title);
    write_words(column, DIM, 2, "%s/%s.c", captions->source, step->file);
    write_verdict(column, verdict);
    if (step->pass == EYE_PASS)
        write_words(column, DIM, 2, "it plays in pictures: p renders one");
    if (verdict->state == VERDICT_PASS && verdicts_all_right(verdicts))
        write_words(column, INKS[VERDICT_PASS], 2, "All steps are right! make report, make finale");
    else if (verdict->state == VERDICT_PASS && !verdict->judged_now)
        write_words(column, INKS[VERDICT_PASS], 2, "Right. n: on to %s %s", next->id, next->title);
    write_words(column, (Rgba){190, 205, 255, 255}, 12, "%s", verdicts->hint);
    column->y += 0.5f * column->line;
}

// At the bottom of the column.
static void write_status(Column *column, const char *status)
{
    char wrapped[1200];
    if (!status || !status[0])
        return;
    int lines = overlay_wrap(status, column->scale, column->width, 9, wrapped, sizeof wrapped);
    column->bottom -= (float)lines * column->line;
    canvas_text(column->canvas, column->left, column->bottom, column->scale, DIM, wrapped);
    column->bottom -= 0.5f * column->line;
}

void panel_draw(Canvas *canvas, const View *view, const ViewData *yours, const Captions *captions)
{
    Column column = column_of(canvas, view);
    float left = column.left - column.y; // the margin is the same on all sides
    canvas_rectangle(canvas, left, 0, (float)canvas_width(canvas) - left, (float)canvas_height(canvas), PLATE);
    write_status(&column, captions->status);
    if (captions->verdicts)
        write_marks(&column, captions->verdicts);
    if (captions->banner && captions->banner[0]) {
        Rgba plate = captions->banner_is_old ? (Rgba){58, 62, 70, 255} : (Rgba){120, 16, 20, 255};
        write_on_plate(&column, captions->banner_is_old ? DIM : (Rgba){255, 235, 230, 255}, plate, 10,
                       captions->banner);
        column.y += 0.5f * column.line;
    }
    if (captions->verdicts)
        write_step(&column, captions);
    char text[1024] = "";
    if (captions->pictures[0].rgba)
        text_append(text, sizeof text, "%s", captions->rendered);
    else
        view_type(view)->describe(view, yours, text, sizeof text);
    write_words(&column, COLOUR_OF_TEXT, 9, "%s", text);
    column.y += 0.5f * column.line;
    if (!captions->pictures[0].rgba)
        write_legend(&column, view, yours);
}
