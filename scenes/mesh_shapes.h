// The shapes of make_meshes.c, as points and faces.
#pragma once

#include <math.h>
#include <stdbool.h>

#define PI             3.14159265358979323846
#define MAX_CORNERS    8 // of a face
#define MAX_NEIGHBOURS 16
#define LATTICE        96 // sphere: cells along a cube's edge, 6·96²·2 = 110592 triangles
#define MAX_POINTS     (6 * LATTICE * LATTICE + 2)
#define MAX_FACES      (12 * LATTICE * LATTICE)

typedef struct {
    double x, y, z;
} Point;

typedef struct {
    const char *group;
    int corner_count;
    int corners[MAX_CORNERS]; // anticlockwise seen from outside
} Face;

typedef struct {
    bool smooth, closed; // smooth: every point has a normal; else facets are flat
    int point_count, face_count;
    Point points[MAX_POINTS], normals[MAX_POINTS];
    Face faces[MAX_FACES];
    int neighbours[MAX_POINTS][MAX_NEIGHBOURS]; // of a point: where the edges of its faces lead
    int neighbour_count[MAX_POINTS];
} Mesh;

static double dot(Point a, Point b)
{
    return a.x * b.x + a.y * b.y + a.z * b.z;
}

static Point cross_of_edges(Point a, Point b, Point c) // (b−a) × (c−a)
{
    Point u = {b.x - a.x, b.y - a.y, b.z - a.z}, v = {c.x - a.x, c.y - a.y, c.z - a.z};
    return (Point){u.y * v.z - u.z * v.y, u.z * v.x - u.x * v.z, u.x * v.y - u.y * v.x};
}

static int mesh_point(Mesh *mesh, double x, double y, double z)
{
    mesh->points[mesh->point_count] = (Point){x, y, z};
    return mesh->point_count++;
}

static void mesh_face(Mesh *mesh, const char *group, int count, const int *corners)
{
    Face *face = &mesh->faces[mesh->face_count++];
    face->group = group;
    face->corner_count = count;
    for (int i = 0; i < count; i++) {
        int from = face->corners[i] = corners[i];
        if (mesh->neighbour_count[from] < MAX_NEIGHBOURS)
            mesh->neighbours[from][mesh->neighbour_count[from]++] = corners[(i + 1) % count];
    }
}

// ---- diamond: "ideal" proportions (after Tolkowsky 1919), lengths as shares of the girdle's diameter
#define TABLE               0.55  // width of the table, corner to corner
#define CROWN_ANGLE         34.5  // degrees, kite to girdle plane
#define PAVILION_ANGLE      40.75 // degrees, pavilion main to girdle plane
#define GIRDLE_THICKNESS    0.02
#define STAR_LENGTH         0.50 // of the way from the table's edge to the girdle
#define LOWER_GIRDLE_LENGTH 0.77 // of the way from the girdle to the culet

// Up to 16 corners, 22.5° apart, even ones in the middle of a kite (or main), odd ones on its side, all on
// the kite's plane y + slope·(0.5 − distance outwards), which makes the kites flat. Radius 0: no corners.
static void diamond_corners(Mesh *mesh, double even_radius, double odd_radius, double y, double slope)
{
    for (int i = 0; i < 16; i++) {
        double r = i % 2 == 0 ? even_radius : odd_radius, angle = i * PI / 8.0;
        double outwards = i % 2 == 0 ? r : r * cos(PI / 8.0);
        if (r > 0.0)
            mesh_point(mesh, r * sin(angle), y + slope * (0.5 - outwards), r * cos(angle));
    }
}

static void diamond_points(Mesh *mesh)
{
    double crown = tan(CROWN_ANGLE * PI / 180.0), pavilion = tan(PAVILION_ANGLE * PI / 180.0);
    double top = 0.5 * GIRDLE_THICKNESS, table_edge = 0.5 * TABLE * cos(PI / 8.0);
    double star = table_edge + STAR_LENGTH * (0.5 - table_edge);
    diamond_corners(mesh, 0.5, 0.5, top, 0.0);                                      // 0…15 girdle
    diamond_corners(mesh, 0.5, 0.5, -top, 0.0);                                     // 16…31 its lower edge
    diamond_corners(mesh, 0.5 * TABLE, star, top, crown);                           // 32…47 table, star tips
    diamond_corners(mesh, 0.0, 0.5 * (1.0 - LOWER_GIRDLE_LENGTH), -top, -pavilion); // 48…55 pavilion tips
    mesh_point(mesh, 0.0, -top - 0.5 * pavilion, 0.0);                              // 56 culet
}

static void diamond(Mesh *mesh)
{
    mesh->closed = true;
    diamond_points(mesh);
    mesh_face(mesh, "table", 8, (int[]){32, 34, 36, 38, 40, 42, 44, 46});
    // even: a kite's direction, with the odd ones `before` and `after` it; `next`: the next kite's.
    for (int even = 0; even < 16; even += 2) {
        int before = 32 + (even + 15) % 16, after = 33 + even, next = 32 + (even + 2) % 16;
        mesh_face(mesh, "crown", 3, (int[]){32 + even, after, next});         // star
        mesh_face(mesh, "crown", 4, (int[]){32 + even, before, even, after}); // kite
        mesh_face(mesh, "crown", 3, (int[]){after, even, even + 1});          // upper girdle facets, a pair
        mesh_face(mesh, "crown", 3, (int[]){after, even + 1, next - 32});
    }
    for (int i = 0; i < 16; i++)
        mesh_face(mesh, "girdle", 4, (int[]){i, 16 + i, 16 + (i + 1) % 16, (i + 1) % 16});
    for (int even = 0; even < 16; even += 2) {
        int before = 48 + (even + 15) % 16 / 2, after = 48 + even / 2, next = 16 + (even + 2) % 16;
        mesh_face(mesh, "pavilion", 3, (int[]){16 + even, after, 17 + even}); // lower girdle facets, a pair
        mesh_face(mesh, "pavilion", 3, (int[]){17 + even, after, next});
        mesh_face(mesh, "pavilion", 4, (int[]){16 + even, before, 56, after}); // main
    }
}

// ---- sphere: a cube's lattice blown up to a ball (triangles of nearly one size, no poles), then dented

// A sum of plane waves over the unit vector d, and its gradient for the normals. The amplitudes add up to 1.
static double bumps(Point d, Point *gradient)
{
    static const double wave[5][3] = {
        {10.2, 3.4, -4.6}, {-3.8, 9.4, 6.2}, {5.8, -7.4, 8.6}, {-12.2, -5.8, 2.6}, {2.2, 12.6, -10.6}};
    static const double amplitude[5] = {0.28, 0.24, 0.20, 0.16, 0.12};
    double sum = 0.0;
    *gradient = (Point){0.0, 0.0, 0.0};
    for (int i = 0; i < 5; i++) {
        double phase = wave[i][0] * d.x + wave[i][1] * d.y + wave[i][2] * d.z + 1.3 * i;
        double slope = amplitude[i] * cos(phase);
        sum += amplitude[i] * sin(phase);
        gradient->x += slope * wave[i][0];
        gradient->y += slope * wave[i][1];
        gradient->z += slope * wave[i][2];
    }
    return sum;
}

#define BUMP_HEIGHT 0.03 // of the radius

// Surface r(d) = 1 + h·bumps(d): its normal is r·d − (the part of h·∇bumps at right angles to d).
static int bumpy_point(Mesh *mesh, Point d)
{
    Point g;
    double h = BUMP_HEIGHT, r = 1.0 + h * bumps(d, &g), s = r + h * dot(g, d);
    Point n = {s * d.x - h * g.x, s * d.y - h * g.y, s * d.z - h * g.z};
    double length = sqrt(dot(n, n));
    mesh->normals[mesh->point_count] = (Point){n.x / length, n.y / length, n.z / length};
    return mesh_point(mesh, r * d.x, r * d.y, r * d.z);
}

// The point at lattice coordinates c (0…LATTICE); made on first use, so that the cube's sides share them.
static int lattice_point(Mesh *mesh, const int c[3])
{
    static int made[LATTICE + 1][LATTICE + 1][LATTICE + 1]; // 1 + index of the point; 0: not yet
    int *index = &made[c[0]][c[1]][c[2]];
    if (*index == 0) {
        double p[3];
        for (int i = 0; i < 3; i++)
            p[i] = tan((2.0 * c[i] / LATTICE - 1.0) * PI / 4.0); // tan: equal angles, not equal lengths
        double s = 1.0 / sqrt(p[0] * p[0] + p[1] * p[1] + p[2] * p[2]);
        *index = 1 + bumpy_point(mesh, (Point){p[0] * s, p[1] * s, p[2] * s});
    }
    return *index - 1;
}

static void sphere(Mesh *mesh)
{
    mesh->smooth = mesh->closed = true;
    for (int side = 0; side < 6; side++)
        for (int cell = 0; cell < LATTICE * LATTICE; cell++) {
            // On a low side u and v change places: the corners' order turns, and the normal stays outside.
            int axis = side / 2, low = side % 2 == 0, q[4];
            int u = (axis + 1 + low) % 3, v = (axis + 2 - low) % 3;
            for (int i = 0; i < 4; i++) {
                int c[3];
                c[axis] = low ? 0 : LATTICE;
                c[u] = cell % LATTICE + (i == 1 || i == 2);
                c[v] = cell / LATTICE + (i >= 2);
                q[i] = lattice_point(mesh, c);
            }
            mesh_face(mesh, "sphere", 3, (int[]){q[0], q[1], q[2]});
            mesh_face(mesh, "sphere", 3, (int[]){q[0], q[2], q[3]});
        }
}

// ---- ring
#define RING_SEGMENTS 1440
#define RING_HEIGHT   0.25

static void ring(Mesh *mesh)
{
    mesh->smooth = true;
    for (int i = 0; i < RING_SEGMENTS; i++) {
        double angle = 2.0 * PI * i / RING_SEGMENTS;
        Point inwards = {-cos(angle), 0.0, -sin(angle)};
        for (int top = 0; top < 2; top++) {
            mesh->normals[mesh->point_count] = inwards;
            mesh_point(mesh, cos(angle), top * RING_HEIGHT, sin(angle));
        }
        int next = (i + 1) % RING_SEGMENTS;
        mesh_face(mesh, "ring", 4, (int[]){2 * i, 2 * next, 2 * next + 1, 2 * i + 1});
    }
}
