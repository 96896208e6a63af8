// Writes scenes/README.md, the page of the scene format, from the rows that scene files are read by. With --words: the
// words of the format as a dictionary for the fuzzer.
#include "scene_page/scene_rows.h"

#include "scene/glass_catalogue.h"

#include <stdio.h>
#include <string.h>

static const char head[] =
    "# The scene file\n"
    "\n"
    "A scene is a YAML file of at most 4 MiB: keys with values, lists with an entry per `- `, comments behind `#`. The scenes in\n"
    "this folder show every shape, light and material there is. Lengths are metres, angles degrees, powers watts. Axes are\n"
    "right-handed, with y up unless the camera says otherwise. Colours are three numbers for red, green and blue. Meshes are\n"
    "looked for in the scene's folder.\n"
    "\n"
    "Numbers lie between -1e9 and 1e9, with a point for the decimals; whole ones are written without a point or an exponent.\n"
    "Aliases (`*name`) and second documents are refused. A mistake is answered with file, line, column and what was expected.\n"
    "\n"
    "<!-- teachers -->\n"
    "This page is written by `make scene-page`, from the rows that the program reads scenes by.\n"
    "<!-- end of teachers -->\n";

static void print_range(const SceneKey *key)
{
    const SceneRange *range = &key->range;
    bool above = range->high == SCENE_LARGEST_NUMBER;
    if (key->kind == KEY_TYPE || (above && range->low == -SCENE_LARGEST_NUMBER))
        return;
    if (above && range->expected)
        printf("%s", range->low > 0 ? "above 0" : "0 or more");
    else
        printf("%.10g to %.10g%s", range->low, range->high, range->open ? ", both excluded" : "");
}

static void print_keys(const SceneKey *key)
{
    static const char *const kinds[] = {
        [KEY_NUMBER] = "number",    [KEY_WHOLE] = "whole number", [KEY_THREE] = "[x, y, z]",
        [KEY_COLOUR] = "[r, g, b]", [KEY_WORD] = "word",          [KEY_TYPE] = "word",
    };
    if (key->name)
        printf("\n| key | value | range | unit | if left out | meaning |\n|---|---|---|---|---|---|\n");
    for (; key->name; key++) {
        printf("| `%s` | %s | ", key->name, kinds[key->kind]);
        print_range(key);
        printf(" | %s | %s | %s |\n", key->range.unit ? key->range.unit : "",
               key->otherwise ? key->otherwise : "**required**", key->meaning);
    }
}

static void print_section(const SceneSection *section)
{
    const SceneType *type;
    printf("\n## %s\n\n%s", section->name, section->meaning);
    if (section->most)
        printf(" A list of at most %zu entries%s.", section->most, section->required ? ", one at least" : "");
    else
        printf(" %s.", section->required ? "Required" : "May be left out");
    printf("\n");
    print_keys(section->keys);
    for (size_t i = 0; (type = scene_type_at(section, i)); i++) {
        if (section->most)
            printf("\n### %s: `%s`\n\n%s\n", section->name, type->name, type->meaning);
        else
            printf("\n%s\n", type->meaning);
        print_keys(type->keys);
        printf("\n    %s%s\n", section->most ? "- " : "", type->example);
    }
}

static void print_glasses(void)
{
    const SellmeierGlass *glass;
    printf(
        "\n## Glasses of the catalogue\n\nRefractive indices by Sellmeier's formula, at the wavelengths of red, green and "
        "blue.\n\n| `glass` | %.0f nm | %.0f nm | %.0f nm | source |\n|---|---|---|---|---|\n",
        WAVELENGTH_RED, WAVELENGTH_GREEN, WAVELENGTH_BLUE);
    for (size_t i = 0; (glass = glass_at(i)); i++)
        printf("| %s | %.4f | %.4f | %.4f | %s |\n", glass->name, glass_index(glass, WAVELENGTH_RED),
               glass_index(glass, WAVELENGTH_GREEN), glass_index(glass, WAVELENGTH_BLUE), glass->source);
}

static void print_words(void)
{
    for (int s = 0; s < SCENE_SECTIONS; s++) {
        const SceneType *type;
        const SceneKey *key;
        printf("\"%s: \"\n", scene_sections[s]->name);
        for (size_t i = 0; (key = scene_key_at(scene_sections[s], i)); i++)
            printf("\"%s: \"\n", key->name);
        for (size_t i = 0; scene_sections[s]->most && (type = scene_type_at(scene_sections[s], i)); i++)
            printf("\"%s\"\n", type->name);
    }
    const SellmeierGlass *glass;
    for (size_t i = 0; (glass = glass_at(i)); i++)
        printf("\"%s\"\n", glass->name);
}

int main(int count, char **arguments)
{
    if (count > 1 && strcmp(arguments[1], "--words") == 0) {
        print_words();
        return 0;
    }
    if (!scene_rows_are_sound())
        return 1;
    printf("%s", head);
    for (int s = 0; s < SCENE_SECTIONS; s++)
        print_section(scene_sections[s]);
    print_glasses();
    return 0;
}
