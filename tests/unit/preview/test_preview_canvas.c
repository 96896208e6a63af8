// Drawing without a display: shapes where they belong, light that adds up.
#include "unit/preview/canvas_helpers.h"

// A square of pixels [x, x+size)².
static void square(Vertex out[6], float x, float y, float z, float size, uint8_t r, uint8_t g, uint8_t b)
{
    static const int CORNERS[6] = {0, 1, 3, 0, 3, 2};
    for (int i = 0; i < 6; i++)
        out[i] = (Vertex){x + (CORNERS[i] & 1 ? size : 0), y + (CORNERS[i] & 2 ? size : 0), z, r, g, b, 255};
}

// ---- Shapes ----

TEST(shapes_are_where_they_belong)
{
    Canvas *canvas = new_canvas();
    Vertex vertices[6];
    square(vertices, 10, 20, 0, 5, 250, 100, 50);
    canvas_draw(canvas, vertices, 6, &(DrawStyle){.kind = DRAW_TRIANGLES});
    Vertex point = {100.5f, 3.5f, 0, 1, 2, 3, 255};
    canvas_draw(canvas, &point, 1, &(DrawStyle){.kind = DRAW_POINTS});
    Vertex line[2] = {{20.5f, 60.5f, 0, 0, 255, 0, 255}, {30.5f, 60.5f, 0, 0, 255, 0, 255}};
    canvas_draw(canvas, line, 2, &(DrawStyle){.kind = DRAW_LINES});
    look(canvas);
    assert_pixel(10, 20, 250, 100, 50);
    assert_pixel(14, 24, 250, 100, 50);
    assert_pixel(100, 3, 1, 2, 3);
    assert_pixel(25, 60, 0, 255, 0);
    assert_int_equal(count_lit(10, 20, 5, 5), 25);
    assert_int_equal(count_lit(20, 60, 11, 1), 10); // OpenGL leaves out a line's last pixel
    assert_int_equal(count_all(), 25 + 1 + 10);
}

TEST(large_points_and_rectangles_have_their_size)
{
    Canvas *canvas = new_canvas();
    Vertex point = {50, 50, 0, 255, 255, 255, 255};
    canvas_draw(canvas, &point, 1, &(DrawStyle){.kind = DRAW_POINTS, .point_size = 4});
    canvas_rectangle(canvas, 100, 90, 20, 10, (Rgba){0, 0, 200, 255});
    look(canvas);
    assert_int_equal(count_lit(48, 48, 4, 4), 16);
    assert_int_equal(count_all(), 16 + 200);
    assert_pixel(119, 99, 0, 0, 200);
}

TEST(a_view_ends_at_its_rectangle)
{
    static const float SAME[16] = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};
    Canvas *canvas = new_canvas();
    canvas_view(canvas, 80, 10, 60, 30, SAME);
    Vertex vertices[6], point = {0.5f, 0.5f, 0, 0, 0, 9, 255}; // three quarters right, one quarter down
    square(vertices, -9, -9, 0, 18, 9, 9, 9);
    canvas_draw(canvas, vertices, 6, &(DrawStyle){.kind = DRAW_TRIANGLES});
    Vertex edge = {-1, 0, 0, 9, 9, 9, 255};
    canvas_draw(canvas, &edge, 1, &(DrawStyle){.kind = DRAW_POINTS, .point_size = 8});  // half of it is outside
    canvas_rectangle(canvas, 0, 0, 1, 1, (Rgba){5, 5, 5, 255});                         // not bound to the view
    canvas_draw(canvas, &point, 1, &(DrawStyle){.kind = DRAW_POINTS, .point_size = 2}); // which is still there
    look(canvas);
    assert_int_equal(count_lit(80, 10, 60, 30), 60 * 30);
    assert_int_equal(count_all(), 60 * 30 + 1);
    assert_pixel(80 + 45, 10 + 7, 0, 0, 9);
}

TEST(a_new_picture_is_black)
{
    Canvas *canvas = new_canvas();
    canvas_rectangle(canvas, 0, 0, WIDTH, HEIGHT, (Rgba){255, 255, 255, 255});
    look(canvas);
    assert_int_equal(count_all(), WIDTH * HEIGHT);
    canvas_begin(canvas, BLACK);
    look(canvas);
    assert_int_equal(count_all(), 0);
    assert_pixel(0, 0, 0, 0, 0);
}

// ---- Styles ----

TEST(light_adds_up)
{
    Canvas *canvas = new_canvas();
    Vertex point = {50.5f, 50.5f, 0, 100, 40, 0, 255}, half = {60.5f, 50.5f, 0, 200, 100, 0, 51};
    for (int i = 0; i < 3; i++)
        canvas_draw(canvas, &point, 1, &(DrawStyle){.kind = DRAW_POINTS, .additive = true});
    canvas_draw(canvas, &half, 1, &(DrawStyle){.kind = DRAW_POINTS, .additive = true});
    point.x = 70.5f;
    canvas_draw(canvas, &point, 1, &(DrawStyle){.kind = DRAW_POINTS, .additive = true, .exposure = 0.25f});
    point.x = 80.5f;
    canvas_draw(canvas, &point, 1, &(DrawStyle){.kind = DRAW_POINTS, .exposure = 2});
    look(canvas);
    assert_pixel(50, 50, 255, 120, 0);
    assert_pixel(60, 50, 40, 20, 0); // alpha 51/255 = 1/5
    assert_pixel(70, 50, 25, 10, 0);
    assert_pixel(80, 50, 200, 80, 0);
}

TEST(a_glass_colour_lets_half_through)
{
    Canvas *canvas = new_canvas();
    canvas_rectangle(canvas, 0, 0, 10, 10, (Rgba){100, 0, 0, 255});
    canvas_rectangle(canvas, 0, 0, 10, 10, (Rgba){0, 0, 200, 51});
    look(canvas);
    assert_pixel(5, 5, 80, 0, 40);
}

AROUND_TESTS(start, end)
