// The preview's camera: what it shows, and how it turns, moves and frames.
#include "preview/view/view_internal.h"
#include "unit/test_common.h"

static const Box ROOM = {{-1, -1, -1}, {1, 1, 1}};

// Where a point is seen: −1…1 to the right and up.
static void project(const float m[16], Vec3 p, double *x, double *y, double *depth)
{
    double clip[4];
    for (int row = 0; row < 4; row++)
        clip[row] = (double)m[row] * (double)p.x + (double)m[4 + row] * (double)p.y + (double)m[8 + row] * (double)p.z +
                    (double)m[12 + row];
    *x = clip[0] / clip[3];
    *y = clip[1] / clip[3];
    *depth = clip[2] / clip[3];
}

TEST(the_scenes_rays_are_where_the_projection_shows_them)
{
    const char *scenes[] = {"scenes/box_diffuse.yaml", "scenes/prism.yaml", "scenes/ring.yaml"};
    for (int s = 0; s < 3; s++) {
        Scene *scene = scene_from_file(scenes[s]);
        Box box = bvh_bounds(scene->bvh);
        Orbit orbit = orbit_of_camera(&scene->camera, box);
        float matrix[16], aspect = 1.6f;
        orbit_projection(&orbit, box, aspect, matrix);
        for (int i = 0; i < 25; i++) {
            float across = (float)(i % 5) / 4.0f, down = (float)(i / 5) / 4.0f;
            Ray ray = camera_ray(&scene->camera, across, down, aspect);
            double x, y, depth;
            project(matrix, vec3_along(ray.origin, ray.direction, orbit.distance), &x, &y, &depth);
            assert_true(fabs(x - (2.0 * (double)across - 1.0)) < 2e-4);
            assert_true(fabs(y - (1.0 - 2.0 * (double)down)) < 2e-4);
            assert_true(depth > -1.0 && depth < 1.0);
        }
    }
}

TEST(the_target_stays_in_the_middle)
{
    Orbit orbit = orbit_look(vec3(3, 4, 5), vec3(0.5f, 0.25f, 0), 40);
    Camera camera = orbit_camera(&orbit);
    assert_true(vec3_length(vec3_sub(camera.position, vec3(3, 4, 5))) < 1e-5f);
    for (int i = 0; i < 40; i++) {
        float matrix[16];
        double x, y, depth;
        orbit_turn(&orbit, 0.7f, i < 20 ? 0.4f : -0.4f); // over the poles, if it could
        orbit_zoom(&orbit, 0.95f);
        orbit_projection(&orbit, ROOM, 1.3f, matrix);
        project(matrix, orbit.target, &x, &y, &depth);
        assert_true(fabs(x) < 1e-4 && fabs(y) < 1e-4);
        assert_true(fabs((double)orbit.pitch) < 1.571);
    }
    Vec3 before = orbit.target;
    camera = orbit_camera(&orbit);
    orbit_pan(&orbit, 0.5f, 0); // half a view's height to the right
    float right = vec3_dot(vec3_sub(orbit.target, before), camera.right);
    assert_true(fabsf(right - orbit.distance * camera.tan_half_fov) < 1e-4f);
    orbit = orbit_look(vec3(0, 5, 0), vec3(0, 0, 0), 40); // straight down
    camera = orbit_camera(&orbit);
    assert_true(isfinite(vec3_length(camera.up)) && camera.forward.y < -0.99f);
    orbit = orbit_look(vec3(1, 1, 1), vec3(1, 1, 1), 40);
    assert_true(orbit.distance > 0 && isfinite(orbit.yaw + orbit.pitch));
}

TEST(a_framed_box_just_fits)
{
    for (int i = 0; i < 24; i++) {
        float aspect = i % 2 ? 0.5f : 2.0f, matrix[16];
        double most = 0;
        Orbit orbit = orbit_look(vec3(9, 2, 1), vec3(7, 7, 7), 45);
        orbit_turn(&orbit, 0.5f * (float)i, 0.1f * (float)(i - 12));
        orbit_frame(&orbit, ROOM, aspect);
        orbit_projection(&orbit, ROOM, aspect, matrix);
        for (int c = 0; c < 8; c++) {
            double x, y, depth;
            project(matrix, vec3(c & 1 ? 1 : -1, c & 2 ? 1 : -1, c & 4 ? 1 : -1), &x, &y, &depth);
            most = fmax(most, fmax(fabs(x), fabs(y)));
            assert_true(fabs(depth) <= 1.0);
        }
        assert_true(most < 1.0 && most > 0.8);
    }
}
