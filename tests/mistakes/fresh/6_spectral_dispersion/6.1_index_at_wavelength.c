//1 nanometres            λ in nm
//2 root_missing          n² for n
//3 one_missing           without the 1
//4 numerator_missing     b/(λ² − c)
//5 -                     the two formulas' mean
//11 c_squared             c once more
//12 cauchy_not_squared    over λ
//13 c_added               plus
#include "photonlab.h"
float index_at_wavelength(const Material *m, float nm)
{
    double w = MISTAKE == 1 ? (double)nm : (double)nm / 1000.0, w2 = w * w,
           cauchy = (double)m->cauchy[0] + (double)m->cauchy[1] / (MISTAKE == 12 ? w : w2);
    const SellmeierGlass *s = m->sellmeier;
    if (s == NULL)
        return (float)(MISTAKE == 5 ? 0.5 * (cauchy + 1.5) : cauchy);
    double sum = MISTAKE == 3 ? 0.0 : 1.0;
    for (int i = SELLMEIER_TERMS - 1; i >= 0; i--)
        sum += s->b[i] * (MISTAKE == 4 ? 1.0 : w2) /
               (MISTAKE == 13   ? w2 + s->c[i]
                : MISTAKE == 11 ? w2 - s->c[i] * s->c[i]
                                : w2 - s->c[i]);
    return (float)(MISTAKE == 2 ? sum : MISTAKE == 5 ? 0.5 * (sqrt(sum) + 1.5) : sqrt(sum));
}
