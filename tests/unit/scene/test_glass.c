// The glass catalogue against figures computed on their own from the same Sellmeier coefficients
// (refractiveindex.info), and Cauchy's formula through the same points.
#include "unit/test_common.h"

static const struct {
    const char *name;
    double n_c, n_d, n_f, red, green, blue, abbe, cauchy_a, cauchy_b; // B in µm²
} table[] = {
    {"N-BK7", 1.514322, 1.516800, 1.522376, 1.515861, 1.518566, 1.524070, 64.167, 1.504583, 0.0042176},
    {"N-F2", 1.615058, 1.620053, 1.632078, 1.618132, 1.623750, 1.635935, 36.431, 1.594236, 0.0089127},
    {"SF10", 1.720848, 1.728250, 1.746481, 1.725388, 1.733802, 1.752421, 28.410, 1.689368, 0.0134233},
    {"N-SF10", 1.720906, 1.728277, 1.746431, 1.725428, 1.733802, 1.752358, 28.533, 1.689560, 0.0133662},
    {"SF11", 1.775988, 1.784720, 1.806454, 1.781336, 1.791305, 1.813604, 25.757, 1.738506, 0.0159543},
    {"N-SF11", 1.775955, 1.784720, 1.806513, 1.781326, 1.791322, 1.813689, 25.680, 1.738368, 0.0160019},
    {"fused_silica", 1.456367, 1.458464, 1.463126, 1.457671, 1.459948, 1.464531, 67.821, 1.448210, 0.0035399},
    {"diamond", 2.409906, 2.417486, 2.435538, 2.414566, 2.423092, 2.441174, 55.301, 2.378605, 0.0134227},
    {"water_20C", 1.331513, 1.333403, 1.337492, 1.332695, 1.334716, 1.338712, 55.760, 1.324334, 0.0031311},
};
enum { GLASSES = sizeof table / sizeof table[0] };

TEST(test_indices)
{
    for (int i = 0; i < GLASSES; i++) {
        const SellmeierGlass *glass = glass_find(table[i].name);
        assert_non_null(glass);
        assert_near(glass_index(glass, 656.273), table[i].n_c, 1e-6);
        assert_near(glass_index(glass, 587.562), table[i].n_d, 1e-6);
        assert_near(glass_index(glass, 486.133), table[i].n_f, 1e-6);
        assert_near(glass_index(glass, WAVELENGTH_RED), table[i].red, 1e-6);
        assert_near(glass_index(glass, WAVELENGTH_GREEN), table[i].green, 1e-6);
        assert_near(glass_index(glass, WAVELENGTH_BLUE), table[i].blue, 1e-6);
    }
}

TEST(test_abbe_number)
{
    for (int i = 0; i < GLASSES; i++) {
        const SellmeierGlass *glass = glass_find(table[i].name);
        double n_d = glass_index(glass, 587.562);
        double spread = glass_index(glass, 486.133) - glass_index(glass, 656.273);
        assert_near((n_d - 1) / spread, table[i].abbe, 1e-3);
    }
}

TEST(test_cauchy)
{
    for (int i = 0; i < GLASSES; i++) {
        double n_d = table[i].n_d, abbe = table[i].abbe;
        assert_near(cauchy_index(n_d, abbe, 587.562), n_d, 1e-12);
        double spread = cauchy_index(n_d, abbe, 486.133) - cauchy_index(n_d, abbe, 656.273);
        assert_near((n_d - 1) / spread, abbe, 1e-9);
        // From two wavelengths back to A and B.
        double at_500 = cauchy_index(n_d, abbe, 500), at_1000 = cauchy_index(n_d, abbe, 1000);
        double b = (at_500 - at_1000) / 3.0; // 1/0.5² − 1/1² = 3
        assert_near(b, table[i].cauchy_b, 2e-6);
        assert_near(at_1000 - b, table[i].cauchy_a, 5e-6);
    }
}

TEST(test_names)
{
    for (int i = 0; i < GLASSES; i++)
        assert_string_equal(glass_at((size_t)i)->name, table[i].name);
    assert_null(glass_at(GLASSES));
    assert_ptr_equal(glass_find("n-sf11"), glass_find("N-SF11"));
    assert_null(glass_find("N-SF1"));
    assert_null(glass_find(""));
}
