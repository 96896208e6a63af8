#include "photons/photon_file.h"
#include "base/file.h"

bool photon_file_path_is_known(const char *path, Error *error)
{
    return file_ends_in(path, ".ply") || file_ends_in(path, ".csv") ||
           error_set(error, "%s: unknown ending; expected .ply or .csv", path);
}

// A photon's power scaled so that its strongest channel is 255. Of a single wavelength a channel may lie below 0; of a wrong
// step it may be infinite, or no number.
static void display_colour(const StoredPhoton *photon, unsigned char rgb[3])
{
    float most = colour_max(photon->power);
    for (int c = 0; c < 3; c++) {
        float scaled = most > 0.0f ? 255.0f * fmaxf(colour_channel(photon->power, c), 0.0f) / most + 0.5f : 0.0f;
        rgb[c] = scaled < 256.0f ? (unsigned char)scaled : 255;
    }
}

static void write_ply(const StoredPhoton *photons, size_t count, FILE *stream)
{
    fprintf(stream,
            "ply\nformat binary_little_endian 1.0\ncomment photonlab stored photons\nelement vertex %zu\n"
            "property float x\nproperty float y\nproperty float z\n"
            "property float nx\nproperty float ny\nproperty float nz\n"
            "property uchar red\nproperty uchar green\nproperty uchar blue\n"
            "property float power_red\nproperty float power_green\nproperty float power_blue\n"
            "property uchar colour\nproperty uchar path\nproperty uchar bounce\nproperty uchar material\n"
            "end_header\n",
            count);
    for (size_t i = 0; i < count; i++) {
        const StoredPhoton *photon = &photons[i];
        unsigned char record[43], *at = record;
        Vec3 wi = stored_photon_wi(photon);
        for (int axis = 0; axis < 3; axis++)
            at = file_put_float(at, vec3_component(photon->position, axis));
        for (int axis = 0; axis < 3; axis++)
            at = file_put_float(at, vec3_component(wi, axis));
        display_colour(photon, at);
        at += 3;
        for (int c = 0; c < 3; c++)
            at = file_put_float(at, colour_channel(photon->power, c));
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
    if (file_ends_in(path, ".ply"))
        write_ply(photons, count, writer.stream);
    else
        write_csv(photons, count, writer.stream);
    return file_write_end(&writer, true, error);
}
