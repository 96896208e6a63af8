// What stands on a canvas: buffers of vertices, words, pictures; and its size.
#include "unit/preview/canvas_helpers.h"

TEST(a_buffer_is_drawn_in_parts)
{
    Canvas *canvas = new_canvas();
    VertexBuffer buffer = {.array = 0};
    Vertex points[8];
    for (int i = 0; i < 8; i++)
        points[i] = (Vertex){10.5f * (float)i + 0.5f, 5.5f, 0, 255, 255, 255, 255};
    const DrawStyle style = {.kind = DRAW_POINTS};
    assert_int_equal(buffer.count, 0);
    vertex_buffer_upload(canvas, &buffer, points, 8);
    assert_int_equal(buffer.count, 8);
    static const struct {
        size_t first, count;
        int drawn;
    } PARTS[] = {{0, 8, 8}, {2, 3, 3}, {6, 100, 2}, {8, 1, 0}, {1000, SIZE_MAX, 0}, {1, SIZE_MAX, 7}, {3, 0, 0}};
    for (size_t i = 0; i < sizeof PARTS / sizeof *PARTS; i++) {
        begin(canvas);
        vertex_buffer_draw(canvas, &buffer, PARTS[i].first, PARTS[i].count, &style);
        look(canvas);
        assert_int_equal(count_all(), PARTS[i].drawn);
    }
    vertex_buffer_upload(canvas, &buffer, points, 1);
    begin(canvas);
    vertex_buffer_draw(canvas, &buffer, 0, 8, &style);
    look(canvas);
    assert_int_equal(count_all(), 1);
    vertex_buffer_upload(canvas, &buffer, NULL, 0);
    vertex_buffer_draw(canvas, &buffer, 0, 8, &style);
    vertex_buffer_free(canvas, &buffer);
}

TEST(words_stay_in_their_lines)
{
    static const Rgba WHITE = {255, 255, 255, 255};
    Canvas *canvas = new_canvas();
    if (!canvas_has_letters()) {
        print_message("skipped: no font, or built without stb_truetype\n");
        skip();
    }
    canvas_text(canvas, 20, 30, 1, WHITE, "photon\n~|@ \xc2\xb5\x01\x7f");
    look(canvas);
    float width = canvas_text_width(1, "photon");
    int line = (int)LINE_HEIGHT, first = count_lit(20, 30, (int)width + 2, line),
        second = count_lit(20, 30 + line, 80, line);
    assert_true(width > 2 * EM && width < 6 * EM);
    assert_true(first > 100 && second > 50);
    assert_int_equal(count_all(), first + second);
    assert_true(fabsf(canvas_text_width(2, "photon") - 2 * width) < 0.01f);
    assert_true(canvas_text_width(1, "photon\nx") == width);
    assert_true(canvas_text_width(1, "\xff") == canvas_text_width(1, "?"));
    assert_true(canvas_text_width(1, "\xc2") == canvas_text_width(1, "?")); // cut off
    assert_true(canvas_text_width(1, "\xf4\x8f\xbf\xbf") == canvas_text_width(1, "?"));
    assert_true(canvas_text_width(1, "✓") > 0 && canvas_text_width(1, "✓") != canvas_text_width(1, "?"));
    assert_true(canvas_text_width(1, "a\tb") == canvas_text_width(1, "iii\tb")); // a column begins there
}

TEST(a_picture_stands_upright)
{
    static const uint8_t PICTURE[16] = {255, 0, 0, 255, 0, 255, 0, 255, 0, 0, 255, 255, 9, 9, 9, 255};
    Canvas *canvas = new_canvas();
    canvas_picture(canvas, 30, 40, 40, 20, PICTURE, 2, 2);
    look(canvas);
    assert_pixel(30, 40, 255, 0, 0);
    assert_pixel(69, 40, 0, 255, 0);
    assert_pixel(30, 59, 0, 0, 255);
    assert_pixel(69, 59, 9, 9, 9);
    assert_int_equal(count_all(), 800);
    // Afterwards all is as it was: the program and the view.
    static const float SAME[16] = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};
    canvas_view(canvas, 100, 0, 20, 20, SAME);
    canvas_picture(canvas, 0, 0, 1, 1, PICTURE, 2, 2);
    Vertex point = {0.05f, -0.05f, 0, 1, 2, 3, 255};
    canvas_draw(canvas, &point, 1, &(DrawStyle){.kind = DRAW_POINTS});
    look(canvas);
    assert_pixel(110, 10, 1, 2, 3);
}

TEST(a_canvas_changes_its_size)
{
    Canvas *canvas = new_canvas();
    assert_refused(canvas_resize(canvas, 0, 10, &said), "0 x 10");
    assert_false(canvas_resize(canvas, 1 << 30, 10, &said));
    assert_int_equal(canvas_width(canvas), WIDTH);
    assert_true(canvas_resize(canvas, 33, 21, &said));
    assert_int_equal(canvas_width(canvas), 33);
    assert_int_equal(canvas_height(canvas), 21);
    canvas_begin(canvas, BLACK);
    canvas_rectangle(canvas, 32, 20, 50, 50, (Rgba){1, 2, 3, 255});
    memset(seen, 77, sizeof seen);
    canvas_read(canvas, seen);
    const size_t last = 4 * (33 * 21 - 1);
    assert_memory_equal(seen + last, ((const uint8_t[5]){1, 2, 3, 255, 77}), 5);
    assert_int_equal(seen[last - 1], 255);
    assert_int_equal(seen[last - 2], 0);
}

AROUND_TESTS(start, end)
