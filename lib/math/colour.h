// Colours: one number each for red, green and blue, linear in light. What they measure (radiance in W/(m²·sr),
// flux in W, reflectance without unit) is said where they are used.
#pragma once

typedef struct {
    float r, g, b;
} Colour;

static inline Colour colour(float r, float g, float b)
{
    return (Colour){r, g, b};
}

static inline Colour colour_grey(float value)
{
    return colour(value, value, value);
}

static inline Colour colour_add(Colour a, Colour b)
{
    return colour(a.r + b.r, a.g + b.g, a.b + b.b);
}

static inline Colour colour_sub(Colour a, Colour b)
{
    return colour(a.r - b.r, a.g - b.g, a.b - b.b);
}

// Channel by channel: light of colour a seen in a surface of reflectance b.
static inline Colour colour_mul(Colour a, Colour b)
{
    return colour(a.r * b.r, a.g * b.g, a.b * b.b);
}

static inline Colour colour_scale(Colour a, float s)
{
    return colour(a.r * s, a.g * s, a.b * s);
}

static inline float colour_sum(Colour a)
{
    return a.r + a.g + a.b;
}

static inline float colour_max(Colour a)
{
    float rg = a.r > a.g ? a.r : a.g;
    return rg > a.b ? rg : a.b;
}

// Channel 0 red, 1 green, 2 blue.
static inline float colour_channel(Colour a, int channel)
{
    return channel == 0 ? a.r : channel == 1 ? a.g : a.b;
}

static inline void colour_set_channel(Colour *a, int channel, float value)
{
    if (channel == 0)
        a->r = value;
    else if (channel == 1)
        a->g = value;
    else
        a->b = value;
}

static inline Colour colour_only(int channel, float value)
{
    Colour result = colour_grey(0.0f);
    colour_set_channel(&result, channel, value);
    return result;
}
