#include "photons/photon_file.h"
#include "base/file.h"

#include <string.h>
#include <strings.h>

static bool ends_in(const char *path, const char *ending)
{
    size_t length = strlen(path);
    size_t wanted = strlen(ending);
    return length > wanted && strcasecmp(path + length - wanted, ending) == 0;
}

bool photon_file_path_is_known(const char *path, Error *error)
{
    return ends_in(path, ".ply") || ends_in(path, ".csv") ||
           error_set(error, "%s: unknown ending; expected .ply or .csv", path);
}

// A photon's power scaled so that its strongest channel is 255.
static void display_colour(const StoredPhoton *photon, unsigned char rgb[3])
{
    float most = colour_max(photon->power);
    for (int c = 0; c < 3; c++)
        rgb[c] = most > 0.0f ? (unsigned char)(255.0f * colour_channel(photon->power, c) / most + 0.5f) : 0;
}

static void put_float(unsigned char **at, float value)
{
    uint32_t bits;
    memcpy(&bits, &value, sizeof bits);
    for (int i = 0; i < 4; i++)
        *(*at)++ = (unsigned char)(bits >> (8 * i)); // little-endian on every machine
}

static void put_vec3(unsigned char **at, float x, float y, float z)
{
    put_float(at, x);
    put_float(at, y);
    put_float(at, z);
}

static void write_ply(const StoredPhoton *photons, size_t count, FILE *stream)
{
    fprintf(stream, "ply\nformat binary_little_endian 1.0\ncomment photonlab stored photons\nelement vertex %zu\n",
            count);
    static const char *const floats[] = {"x", "y", "z", "nx", "ny", "nz"};
    static const char *const powers[] = {"power_red", "power_green", "power_blue"};
    static const char *const bytes[] = {"colour", "path", "bounce", "material"};
    for (int i = 0; i < 6; i++)
        fprintf(stream, "property float %s\n", floats[i]);
    fprintf(stream, "property uchar red\nproperty uchar green\nproperty uchar blue\n");
    for (int i = 0; i < 3; i++)
        fprintf(stream, "property float %s\n", powers[i]);
    for (int i = 0; i < 4; i++)
        fprintf(stream, "property uchar %s\n", bytes[i]);
    fprintf(stream, "end_header\n");
    for (size_t i = 0; i < count; i++) {
        const StoredPhoton *photon = &photons[i];
        unsigned char record[43];
        unsigned char *at = record;
        Vec3 wi = stored_photon_wi(photon);
        put_vec3(&at, photon->position.x, photon->position.y, photon->position.z);
        put_vec3(&at, wi.x, wi.y, wi.z);
        display_colour(photon, at);
        at += 3;
        put_vec3(&at, photon->power.r, photon->power.g, photon->power.b);
        *at++ = photon->colour;
        *at++ = photon->path;
        *at++ = photon->bounce;
        *at++ = photon->material;
        fwrite(record, 1, sizeof record, stream);
    }
}

static void write_csv(const StoredPhoton *photons, size_t count, FILE *stream)
{
    fprintf(stream, "x,y,z,nx,ny,nz,red,green,blue,power_red,power_green,power_blue,colour,path,bounce,material\n");
    for (size_t i = 0; i < count; i++) {
        const StoredPhoton *p = &photons[i];
        unsigned char rgb[3];
        Vec3 wi = stored_photon_wi(p);
        display_colour(p, rgb);
        fprintf(stream, "%.9g,%.9g,%.9g,%.6g,%.6g,%.6g,%d,%d,%d,%.9g,%.9g,%.9g,%d,%d,%d,%d\n", (double)p->position.x,
                (double)p->position.y, (double)p->position.z, (double)wi.x, (double)wi.y, (double)wi.z, rgb[0], rgb[1],
                rgb[2], (double)p->power.r, (double)p->power.g, (double)p->power.b, p->colour, p->path, p->bounce,
                p->material);
    }
}

bool photon_file_write(const StoredPhoton *photons, size_t count, const char *path, Error *error)
{
    FileWriter writer;
    if (!photon_file_path_is_known(path, error) || !file_write_begin(&writer, path, error))
        return false;
    if (ends_in(path, ".ply"))
        write_ply(photons, count, writer.stream);
    else
        write_csv(photons, count, writer.stream);
    return file_write_end(&writer, true, error);
}
