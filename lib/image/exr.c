// EXR by OpenEXR's C interface, OpenEXRCore: linear floats like PFM's, compressed, and what other renderers write. Read are scan lines with
// channels R, G and B, or Y alone; others beside them are left out. exr_none.c stands in where OpenEXR is missing.
#include "image/codec.h"

#include <openexr.h>
#include <string.h>

#pragma GCC diagnostic ignored "-Wmissing-field-initializers" // OpenEXR's own initializers name the first field alone

typedef struct {
    const char *name;
    Error *error;
    const unsigned char *bytes; // reading
    size_t size;
    FILE *stream; // writing
} File;

static void on_error(exr_const_context_t context, exr_result_t code, const char *message)
{
    void *user = NULL;
    (void)code;
    if (exr_get_user_data(context, &user) == EXR_ERR_SUCCESS && user)
        error_set(((File *)user)->error, "%s: EXR: %s", ((File *)user)->name, message);
}

// Near the file's end it asks for more than there is, and looks at how much that was.
static int64_t on_read(exr_const_context_t context, void *user, void *target, uint64_t count, uint64_t offset,
                       exr_stream_error_func_ptr_t fail)
{
    const File *file = user;
    (void)context, (void)fail;
    uint64_t left = offset < file->size ? file->size - offset : 0;
    count = count < left ? count : left;
    memcpy(target, file->bytes + (left ? offset : 0), count);
    return (int64_t)count;
}

static int64_t on_size(exr_const_context_t context, void *user)
{
    (void)context;
    return (int64_t)((const File *)user)->size;
}

// That the stream takes no more shows when the file is closed.
static int64_t on_write(exr_const_context_t context, void *user, const void *bytes, uint64_t count, uint64_t offset,
                        exr_stream_error_func_ptr_t fail)
{
    FILE *stream = ((File *)user)->stream;
    (void)context, (void)fail;
    if (fseek(stream, (long)offset, SEEK_SET) == 0)
        fwrite(bytes, 1, count, stream);
    return (int64_t)count;
}

static exr_context_initializer_t start(File *file)
{
    exr_context_initializer_t with = EXR_DEFAULT_CONTEXT_INITIALIZER;
    with.error_handler_fn = on_error;
    with.user_data = file;
    with.max_image_width = with.max_image_height = IMAGE_MAX_SIDE;
    with.flags = EXR_CONTEXT_FLAG_STRICT_HEADER | EXR_CONTEXT_FLAG_DISABLE_CHUNK_RECONSTRUCTION;
    return with;
}

// True when it went well; a reason of OpenEXR's own, where none was told.
static bool went_well(const File *file, exr_result_t result)
{
    return result == EXR_ERR_SUCCESS ||
           error_set(file->error, "%s: EXR: %s", file->name, exr_get_default_error_message(result));
}

static bool refuse(const File *file, const char *found, const char *expected)
{
    return error_set(file->error, "%s: EXR: %s; expected %s", file->name, found, expected);
}

// Where in a Colour a channel goes, in floats; −1: nowhere.
static int place_of(const char *name)
{
    static const char *const names[] = {"R", "G", "B", "Y"};
    for (int i = 0; i < 4; i++)
        if (strcmp(name, names[i]) == 0)
            return i % 3; // grey is spread from red later
    return -1;
}

static bool check_channels(const File *file, exr_context_t context, bool *grey)
{
    const exr_attr_chlist_t *list;
    exr_storage_t storage;
    unsigned found = 0;
    if (!went_well(file, exr_get_storage(context, 0, &storage)) ||
        !went_well(file, exr_get_channels(context, 0, &list)))
        return false;
    if (storage != EXR_STORAGE_SCANLINE)
        return refuse(file, "it is stored in tiles, or deep", "scan lines");
    for (int i = 0; i < list->num_channels; i++) {
        const exr_attr_chlist_entry_t *channel = &list->entries[i];
        int place = place_of(channel->name.str);
        if (place < 0)
            continue;
        if (channel->x_sampling != 1 || channel->y_sampling != 1)
            return refuse(file, "a channel has fewer pixels than others", "all of one size");
        found |= channel->name.str[0] == 'Y' ? 8u : 1u << place;
    }
    *grey = found == 8;
    return found == 8 || found == 7 || refuse(file, "channels are missing", "R, G and B, or Y alone");
}

// Points a chunk's channels to the pixels of its first row.
static void aim(exr_coding_channel_info_t *channels, int count, const Image *image, int row)
{
    for (int i = 0; i < count; i++) {
        exr_coding_channel_info_t *channel = &channels[i];
        int place = place_of(channel->channel_name);
        channel->user_bytes_per_element = sizeof(float);
        channel->user_data_type = EXR_PIXEL_FLOAT;
        channel->user_pixel_stride = sizeof(Colour);
        channel->user_line_stride = (int32_t)sizeof(Colour) * image->width;
        channel->decode_to_ptr = place < 0 ? NULL : (uint8_t *)image_at(image, 0, row) + sizeof(float) * (size_t)place;
    }
}

static bool read_rows(const File *file, exr_context_t context, const Image *image, int top)
{
    exr_chunk_info_t chunk;
    int32_t step = 1;
    bool ok = went_well(file, exr_get_scanlines_per_chunk(context, 0, &step));
    for (int row = 0; row < image->height && ok; row += step) {
        exr_decode_pipeline_t decode = EXR_DECODE_PIPELINE_INITIALIZER;
        ok = went_well(file, exr_read_scanline_chunk_info(context, 0, top + row, &chunk)) &&
             went_well(file, exr_decoding_initialize(context, 0, &chunk, &decode));
        if (ok)
            aim(decode.channels, decode.channel_count, image, row);
        ok = ok && went_well(file, exr_decoding_choose_default_routines(context, 0, &decode)) &&
             went_well(file, exr_decoding_run(context, 0, &decode));
        exr_decoding_destroy(context, &decode);
    }
    return ok;
}

static bool read_all(const File *file, exr_context_t context, Image *image)
{
    exr_attr_box2i_t window;
    bool grey = false;
    if (!check_channels(file, context, &grey) || !went_well(file, exr_get_data_window(context, 0, &window)))
        return false;
    long width = (long)window.max.x - window.min.x + 1, height = (long)window.max.y - window.min.y + 1;
    if (!image_check_size(width, height, file->name, file->error) ||
        !image_create(image, (int)width, (int)height, file->error) || !read_rows(file, context, image, window.min.y))
        return false;
    for (size_t i = 0; grey && i < (size_t)image->width * (size_t)image->height; i++)
        image->pixels[i] = colour_grey(image->pixels[i].r);
    return image_check_finite(image, file->name, file->error);
}

static bool decode(Image *image, const unsigned char *bytes, size_t size, const char *name, Error *error)
{
    File file = {.name = name, .error = error, .bytes = bytes, .size = size};
    exr_context_initializer_t with = start(&file);
    exr_context_t context = NULL;
    with.read_fn = on_read;
    with.size_fn = on_size;
    *image = (Image){0};
    bool ok = went_well(&file, exr_start_read(&context, name, &with)) && read_all(&file, context, image);
    exr_finish(&context);
    if (!ok)
        image_free(image);
    return ok;
}

static bool write_rows(const File *file, exr_context_t context, const Image *image)
{
    exr_chunk_info_t chunk;
    int32_t step = 1;
    bool ok = went_well(file, exr_get_scanlines_per_chunk(context, 0, &step));
    for (int row = 0; row < image->height && ok; row += step) {
        exr_encode_pipeline_t encode = EXR_ENCODE_PIPELINE_INITIALIZER;
        ok = went_well(file, exr_write_scanline_chunk_info(context, 0, row, &chunk)) &&
             went_well(file, exr_encoding_initialize(context, 0, &chunk, &encode));
        if (ok)
            aim(encode.channels, encode.channel_count, image, row);
        ok = ok && went_well(file, exr_encoding_choose_default_routines(context, 0, &encode)) &&
             went_well(file, exr_encoding_run(context, 0, &encode));
        exr_encoding_destroy(context, &encode);
    }
    return ok;
}

static bool encode(const Image *image, FILE *stream, const char *name, int bits, Error *error)
{
    File file = {.name = name, .error = error, .stream = stream};
    exr_context_initializer_t with = start(&file);
    exr_context_t context = NULL;
    int part = 0;
    with.write_fn = on_write;
    (void)bits;
    bool ok = went_well(&file, exr_start_write(&context, name, EXR_WRITE_FILE_DIRECTLY, &with)) &&
              went_well(&file, exr_add_part(context, "photonlab", EXR_STORAGE_SCANLINE, &part)) &&
              went_well(&file, exr_initialize_required_attr_simple(context, part, image->width, image->height,
                                                                   EXR_COMPRESSION_ZIP));
    for (int c = 0; c < 3 && ok; c++)
        ok = went_well(&file, exr_add_channel(context, part, (const char *[]){"R", "G", "B"}[c], EXR_PIXEL_FLOAT,
                                              EXR_PERCEPTUALLY_LOGARITHMIC, 1, 1));
    ok = ok && went_well(&file, exr_write_header(context)) && write_rows(&file, context, image);
    return went_well(&file, exr_finish(&context)) && ok;
}

const ImageFormat image_format_exr = {".exr", "to measure, for other programs", decode, encode, NULL};
