#include "scene/material_kind.h"

#define MATERIAL(name) &material_##name,
const MaterialKind *const material_kinds[] = {
#include "scene/materials.def"
};
const size_t material_kind_count = sizeof material_kinds / sizeof material_kinds[0];

bool material_is_rough(const Material *material)
{
    return material_kind(material)->optics == OPTICS_ROUGH;
}

Colour material_lobe(const Material *material, GlossyModel model, Vec3 wi, Vec3 wo, Vec3 n)
{
    const MaterialKind *kind = material_kind(material);
    if (!kind->lobe || vec3_dot(n, wi) <= 0.0f || vec3_dot(n, wo) <= 0.0f)
        return colour_grey(0.0f);
    return kind->lobe(material, model, wi, wo, n);
}

Colour material_brdf(const Material *material, GlossyModel model, Vec3 wi, Vec3 wo, Vec3 n)
{
    if (vec3_dot(n, wi) <= 0.0f || vec3_dot(n, wo) <= 0.0f)
        return colour_grey(0.0f);
    Colour diffuse = colour_scale(material->diffuse, 1.0f / PI);
    return colour_add(diffuse, material_lobe(material, model, wi, wo, n));
}

Colour material_albedo(const Material *material, GlossyModel model, float cos_wi)
{
    const MaterialKind *kind = material_kind(material);
    if (kind->albedo)
        return kind->albedo(material, model, cos_wi);
    return kind->optics == OPTICS_ROUGH    ? material->diffuse
           : kind->optics == OPTICS_MIRROR ? material->specular
                                           : colour_grey(kind->optics == OPTICS_GLASS ? 1.0f : 0.0f);
}
