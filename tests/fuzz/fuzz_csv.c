// A roster: cells in full rows, which come back the same when they are written and read again; or a message.
#include "class/table/class_table.h"
#include "fuzz/fuzz.h"

static void read_again(const Csv *first)
{
    char *bytes = NULL;
    size_t size = 0;
    FILE *stream = open_memstream(&bytes, &size);
    require(stream != NULL);
    fputs("\xEF\xBB\xBF", stream); // the mark, or a first cell that begins like it would lose it
    for (size_t row = 0; row < first->rows; row++) {
        for (size_t column = 0; column < first->columns; column++)
            csv_write(stream, csv_cell(first, row, column), column == 0);
        fputs(",\r\n", stream); // a last column without a name: commas are what parts the cells
    }
    require(fclose(stream) == 0);
    Csv second;
    Error error = {""};
    require(csv_read(fuzz_file("again.csv", (const uint8_t *)bytes, size), &second, &error));
    require(second.rows == first->rows && second.columns == first->columns + 1);
    for (size_t row = 0; row < first->rows; row++)
        for (size_t column = 0; column < first->columns; column++)
            require(strcmp(csv_cell(first, row, column), csv_cell(&second, row, column)) == 0);
    csv_free(&second);
    free(bytes);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    Csv csv;
    Error error = {""};
    bool fine = csv_read(fuzz_file("roster.csv", data, size), &csv, &error);
    require(fine == !error.message[0]);
    if (fine)
        read_again(&csv);
    csv_free(&csv);
    return 0;
}
