// Reflection of rough materials: BRDF, albedo, and the table of the lobe's integrals.
#include "unit/test_common.h"
#include "scene/material_kind.h"

static LobeTable table;
static const float exponents[5] = {0, 1, 5, 20, 100};

static Material glossy(float exponent)
{
    lobe_table_fill(&table, exponent);
    return (Material){.type = MATERIAL_GLOSSY,
                      .diffuse = {0.1f, 0.2f, 0.3f},
                      .specular = {0.5f, 0.25f, 0.0f},
                      .exponent = exponent,
                      .lobe = &table};
}

// Arvo (1995), Mallett & Yuksel (2020), closed forms checked by quadrature and Monte Carlo.
TEST(lobe_table_values)
{
    static const struct {
        float n, theta;
        double above, weighted;
    } book[] = {
        {0, 0, 6.283185, 3.141593},    {0, 60, 4.188790, 2.356194},   {0, 85, 3.316126, 1.707700},
        {1, 30, 2.931146, 1.844833},   {1, 80, 1.843562, 0.858587},   {2, 45, 1.904130, 1.144409},
        {5, 0, 1.047198, 0.897598},    {5, 60, 0.938796, 0.466218},   {5, 75, 0.766574, 0.293633},
        {10, 60, 0.547818, 0.264279},  {20, 45, 0.299175, 0.201950},  {20, 80, 0.235151, 0.057218},
        {50, 75, 0.119424, 0.031472},  {100, 60, 0.062210, 0.030800}, {100, 85, 0.050348, 0.006013},
        {500, 80, 0.012541, 0.002173}, {1000, 0, 0.006277, 0.006271}, {1000, 85, 0.006259, 0.000547},
    };
    for (size_t i = 0; i < sizeof book / sizeof book[0]; i++) {
        float cosine = (float)cos(book[i].theta / DEGREES);
        lobe_table_fill(&table, book[i].n);
        double printed = 6e-7; // the book's last digit
        assert_within(lobe_lookup(table.above, cosine), book[i].above, 1e-3 * book[i].above + printed, "I_P");
        assert_within(lobe_lookup(table.weighted, cosine), book[i].weighted, 1e-3 * book[i].weighted + printed, "I_M");
    }
}

// A direction about +z from cosθ and azimuth.
static Vec3 direction(double z, double phi)
{
    double r = sqrt(1.0 - z * z);
    return vec3((float)(r * cos(phi)), (float)(r * sin(phi)), (float)z);
}

// f(wi, wo) = f(wo, wi) for the Phong material; not for the source text's scheme, which is none.
TEST(phong_is_reciprocal)
{
    Rng rng = rng_create(51, 0);
    for (int k = 0; k < 5; k++) {
        Material material = glossy(exponents[k]);
        for (int i = 0; i < 2000; i++) {
            Vec3 n = random_direction(&rng), wi = random_direction(&rng), wo = random_direction(&rng);
            wi = vec3_dot(wi, n) < 0.0f ? vec3_negate(wi) : wi;
            wo = vec3_dot(wo, n) < 0.0f ? vec3_negate(wo) : wo;
            float there = material_brdf(&material, GLOSSY_PHONG, wi, wo, n).r;
            float back = material_brdf(&material, GLOSSY_PHONG, wo, wi, n).r;
            assert_true(there >= 0.1f / PI);
            assert_within(back, there, 1e-4 * (double)there, "reciprocity");
        }
    }
    Material material = glossy(20);
    Vec3 up = {0, 0, 1}, a = direction(cos(60.0 / DEGREES), 0.0), b = direction(cos(80.0 / DEGREES), M_PI);
    float there = material_brdf(&material, GLOSSY_SOURCE_TEXT, a, b, up).r;
    assert_true(fabsf(material_brdf(&material, GLOSSY_SOURCE_TEXT, b, a, up).r / there - 1.0f) > 0.1f);
}

// ∫f(wi, wo)·cosθ_o dω over the hemisphere, by the midpoint rule.
static Colour reflected(const Material *material, GlossyModel model, double theta)
{
    enum { ROWS = 600, COLUMNS = 600 };
    Vec3 wi = tilted(theta), up = {0, 0, 1};
    double sum[3] = {0};
    for (int i = 0; i < ROWS; i++) {
        double z = (i + 0.5) / ROWS;
        for (int j = 0; j < COLUMNS / 2; j++) { // the other half is its mirror image
            Colour f = material_brdf(material, model, wi, direction(z, 2.0 * M_PI * (j + 0.5) / COLUMNS), up);
            for (int c = 0; c < 3; c++)
                sum[c] += 2.0 * z * (double)colour_channel(f, c);
        }
    }
    float d = (float)(2.0 * M_PI / ((double)ROWS * COLUMNS));
    return colour_scale(colour((float)sum[0], (float)sum[1], (float)sum[2]), d);
}

TEST(albedo_is_the_integral_of_the_brdf)
{
    for (int k = 0; k < 5; k++) {
        Material material = glossy(exponents[k]);
        for (int theta = 0; theta <= 80; theta += 40) {
            Colour sum = reflected(&material, GLOSSY_PHONG, theta);
            Colour albedo = material_albedo(&material, GLOSSY_PHONG, (float)cos(theta / DEGREES));
            for (int c = 0; c < 3; c++)
                assert_within(colour_channel(albedo, c), colour_channel(sum, c), 1e-3, "Phong albedo");
        }
    }
    Material material = glossy(5); // the book's 0.519407 at 60°
    assert_within(material_albedo(&material, GLOSSY_PHONG, 0.5f).r, 0.1 + 0.5 * 0.519407, 1e-4, "n = 5 at 60 degrees");
}

// The source text sends back all it gets: ρ_d + ρ_s at every angle.
TEST(source_text_reflects_rho)
{
    for (int k = 0; k < 5; k++) {
        Material material = glossy(exponents[k]);
        for (int theta = 0; theta <= 80; theta += 40) {
            Colour sum = reflected(&material, GLOSSY_SOURCE_TEXT, theta);
            Colour albedo = material_albedo(&material, GLOSSY_SOURCE_TEXT, (float)cos(theta / DEGREES));
            for (int c = 0; c < 3; c++) {
                double rho = (double)(colour_channel(material.diffuse, c) + colour_channel(material.specular, c));
                assert_within(colour_channel(sum, c), rho, 2e-3, "source text, integral");
                assert_within(colour_channel(albedo, c), rho, 1e-6, "source text, albedo");
            }
        }
    }
}

TEST(simple_materials)
{
    Material material = {.type = MATERIAL_DIFFUSE, .diffuse = {0.5f, 0.6f, 0.7f}, .specular = {0.9f, 0.8f, 0.7f}};
    Vec3 up = {0, 0, 1};
    assert_within(material_brdf(&material, GLOSSY_PHONG, tilted(30), tilted(-70), up).g, 0.6 / M_PI, 1e-7, "Lambert");
    assert_within(material_albedo(&material, GLOSSY_PHONG, 0.1f).b, 0.7, 1e-7, "diffuse albedo");
    material.type = MATERIAL_MIRROR;
    assert_within(material_albedo(&material, GLOSSY_PHONG, 0.1f).r, 0.9, 1e-7, "mirror");
    material.type = MATERIAL_GLASS;
    assert_within(material_albedo(&material, GLOSSY_PHONG, 0.1f).r, 1.0, 0.0, "glass");
    material.type = MATERIAL_LIGHT;
    assert_within(material_albedo(&material, GLOSSY_PHONG, 0.1f).r, 0.0, 0.0, "light");
    assert_true(material_is_rough(&(Material){.type = MATERIAL_GLOSSY}));
    assert_false(material_is_rough(&(Material){.type = MATERIAL_GLASS}));
}

// Names what a new kind leaves out.
TEST(every_kind_is_whole)
{
    for (size_t i = 0; i < material_kind_count; i++) {
        const MaterialKind *kind = material_kinds[i];
        const SceneType *scene = &kind->scene;
        bool light = kind == &material_light;
        const char *missing = !light && !scene->name                            ? "its name"
                              : !light && !scene->called                        ? "what messages call it"
                              : !light && !scene->meaning                       ? "its meaning"
                              : !light && !scene->keys                          ? "its keys"
                              : !light && !scene->example                       ? "its example"
                              : !light && !kind->build                          ? "its build function"
                              : !kind->optics                                   ? "its optics"
                              : kind->lobe && !kind->albedo                     ? "its albedo"
                              : kind->line[3] == 0                              ? "a visible line"
                              : kind->cosine_lobe && !kind->lobe                ? "its lobe"
                              : (kind->optics == OPTICS_MIRROR) != !!kind->turn ? "its turn, or has one for nothing"
                                                                                : NULL;
        const char *name = light ? "light" : scene->name ? scene->name : "without a name";
        if (missing)
            fail_msg("the material '%s' lacks %s", name, missing);
        if (kind->type != (i < MATERIAL_TYPES ? (MaterialType)i : MATERIAL_GLOSSY))
            fail_msg("the material '%s' has the wrong type, or the wrong place in materials.def", name);
    }
}

TEST(nothing_below_the_surface)
{
    Material material = glossy(20);
    Vec3 up = {0, 0, 1};
    const GlossyModel models[] = {GLOSSY_SOURCE_TEXT, GLOSSY_PHONG};
    for (int k = 0; k < 2; k++) {
        GlossyModel m = models[k];
        assert_true(colour_sum(material_brdf(&material, m, tilted(100), tilted(20), up)) == 0.0f);
        assert_true(colour_sum(material_brdf(&material, m, tilted(20), tilted(100), up)) == 0.0f);
        assert_true(colour_sum(material_brdf(&material, m, tilted(160), tilted(-160), up)) == 0.0f);
        assert_true(material_brdf(&material, m, tilted(20), tilted(-20), up).r > 1.0f);
    }
}
