// Writes the meshes of the example scenes: make_meshes diamond|sphere|ring OUT.obj
//  - diamond: round brilliant, girdle diameter 1 and centred on the origin, table up (+y); flat facets
//  - sphere: ball of radius 1 with gentle waves and smooth normals; 110592 triangles to bend light
//  - ring: inner side of a ring about the y axis, radius 1, y = 0…0.25; smooth normals towards the axis
// Checked before writing: each edge used once in each direction (closed, one orientation), volume positive
// (normals point out), each face's corners in one plane. The same bytes on every run.
#include "mesh_shapes.h"

#include <stdio.h>
#include <string.h>

// ---- checks
static int edge_uses(const Mesh *mesh, int from, int to)
{
    int uses = 0;
    for (int i = 0; i < mesh->neighbour_count[from]; i++)
        uses += mesh->neighbours[from][i] == to;
    return uses;
}

// Edges that are not used exactly once in each direction: 0 for a closed mesh of one orientation.
static int open_edges(const Mesh *mesh)
{
    int open = 0;
    for (int from = 0; from < mesh->point_count; from++)
        for (int i = 0; i < mesh->neighbour_count[from]; i++) {
            int to = mesh->neighbours[from][i];
            open += edge_uses(mesh, from, to) != 1 || edge_uses(mesh, to, from) != 1;
        }
    return open;
}

// Returns the number of triangles; their volume (sum of a·(b×c)/6), how far corners are off their plane.
static int measure(const Mesh *mesh, double *volume, double *bend)
{
    int triangles = 0;
    for (int f = 0; f < mesh->face_count; f++) {
        const int *c = mesh->faces[f].corners;
        Point a = mesh->points[c[0]], n = cross_of_edges(a, mesh->points[c[1]], mesh->points[c[2]]);
        for (int i = 1; i + 1 < mesh->faces[f].corner_count; i++, triangles++) {
            Point q = mesh->points[c[i + 1]], m = cross_of_edges(a, mesh->points[c[i]], q);
            *volume += dot(a, m) / 6.0;
            *bend = fmax(*bend, fabs(dot(n, q) - dot(n, a)) / sqrt(dot(n, n)));
        }
    }
    return triangles;
}

static bool mesh_write(const Mesh *mesh, FILE *file)
{
    for (int i = 0; i < mesh->point_count; i++)
        fprintf(file, "v %.9g %.9g %.9g\n", mesh->points[i].x, mesh->points[i].y, mesh->points[i].z);
    for (int i = 0; mesh->smooth && i < mesh->point_count; i++)
        fprintf(file, "vn %.7g %.7g %.7g\n", mesh->normals[i].x, mesh->normals[i].y, mesh->normals[i].z);
    for (int f = 0; f < mesh->face_count; f++) {
        const Face *face = &mesh->faces[f];
        if (f == 0 || strcmp(face->group, face[-1].group) != 0)
            fprintf(file, "g %s\n", face->group);
        for (int i = 0; i < face->corner_count; i++) {
            int c = face->corners[i] + 1; // OBJ counts from 1
            fprintf(file, i == 0 ? "f %d" : " %d", c);
            if (mesh->smooth)
                fprintf(file, "//%d", c);
        }
        fprintf(file, "\n");
    }
    return !ferror(file);
}

int main(int argc, char **argv)
{
    static Mesh mesh;
    const char *kind = argc == 3 ? argv[1] : "";
    if (strcmp(kind, "diamond") == 0) {
        diamond(&mesh);
    } else if (strcmp(kind, "sphere") == 0) {
        sphere(&mesh);
    } else if (strcmp(kind, "ring") == 0) {
        ring(&mesh);
    } else {
        fprintf(stderr, "usage: make_meshes diamond|sphere|ring OUT.obj\n");
        return 1;
    }
    double volume = 0.0, bend = 0.0;
    int open = open_edges(&mesh), triangles = measure(&mesh, &volume, &bend);
    if ((mesh.closed && (open != 0 || volume <= 0.0)) || bend > 1e-9) {
        fprintf(stderr, "%s: %d open edges, volume %g, %g out of plane\n", argv[1], open, volume, bend);
        return 1;
    }
    FILE *file = fopen(argv[2], "w");
    bool written = file != NULL && mesh_write(&mesh, file);
    if (file == NULL || fclose(file) != 0 || !written) {
        perror(argv[2]);
        return 1;
    }
    printf("%s: %d points, %d faces, %d triangles, %s, volume %.6f\n", argv[1], mesh.point_count, mesh.face_count,
           triangles, mesh.closed ? "closed" : "open", volume);
    return 0;
}
