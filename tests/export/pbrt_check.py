"""Reads exported .pbrt files as pbrt-v4 would, as far as its file format's page goes: blocks closed, types and parameters known there, materials
and meshes that are named there at all. Prints what is wrong. Usage: pbrt_check.py FILE.pbrt…"""
import os
import re
import sys

# Directive → number of words behind its name → what may stand after them. Types: parameters that this one takes.
NUMBERS = {"Scale": 3, "Translate": 3, "LookAt": 9}
BARE = {"WorldBegin", "AttributeBegin", "AttributeEnd"}
TAKES = {
    "Camera perspective": ["float fov"],
    "Film rgb": ["integer xresolution", "integer yresolution", "string filename"],
    "PixelFilter box": ["float xradius", "float yradius"],
    "Sampler independent": ["integer pixelsamples"],
    "Integrator path": ["integer maxdepth"],
    "LightSource point": ["point3 from", "rgb I", "spectrum I", "float scale"],
    "LightSource spot": ["point3 from", "point3 to", "rgb I", "spectrum I", "float scale", "float coneangle", "float conedeltaangle"],
    "AreaLightSource diffuse": ["rgb L", "spectrum L", "float scale"],
    "Shape plymesh": ["string filename"],
    "Shape sphere": ["float radius"],
    "Material diffuse": ["rgb reflectance"],
    "Material conductor": ["rgb reflectance", "float roughness", "bool remaproughness"],
    "Material dielectric": ["float eta", "spectrum eta"],
    "Material mix": ["string materials", "float amount"],
}
HOW_MANY = {"point3": 3, "rgb": 3, "float": 1, "integer": 1, "bool": 1}


def parameters(tokens):
    found = {}
    while tokens and re.match(r'"\w+ \w+"$', tokens[0]):
        name = tokens.pop(0).strip('"')
        assert tokens.pop(0) == "[", f"{name}: no ["
        values = []
        while tokens[0] != "]":
            values.append(tokens.pop(0).strip('"'))
        tokens.pop(0)
        kind = name.split()[0]
        assert len(values) == HOW_MANY.get(kind, len(values)) and values, f"{name}: {len(values)} values"
        if kind in ("float", "integer", "rgb", "point3", "spectrum"):
            numbers = [float(v) for v in values]
            assert all(abs(x) < 1e18 for x in numbers), f"{name}: {values}"
            assert kind != "rgb" or "reflectance" not in name or all(0 <= x <= 1 for x in numbers), f"{name}: {values}"
            nm = numbers[::2]
            assert kind != "spectrum" or (len(numbers) % 2 == 0 and nm == sorted(set(nm))), f"{name}: wavelengths must rise"
        assert name not in found, f"{name} twice"
        found[name] = values
    return found


def check(path):
    tokens = re.findall(r'"[^"]*"|[\[\]]|[^\s"\[\]]+', re.sub(r"#.*", "", open(path).read()))
    materials, depth, in_world, shapes = set(), 0, False, 0
    while tokens:
        word = tokens.pop(0)
        if word in NUMBERS:
            [float(tokens.pop(0)) for _ in range(NUMBERS[word])]
        elif word in BARE:
            depth += {"AttributeBegin": 1, "AttributeEnd": -1}.get(word, 0)
            in_world = in_world or word == "WorldBegin"
        elif word == "NamedMaterial":
            name = tokens.pop(0).strip('"')
            assert name in materials, f"no material {name}"
        else:
            kind = tokens.pop(0).strip('"')
            takes, name = parameters(tokens), kind
            if word == "MakeNamedMaterial":
                word, kind = "Material", takes.pop("string type")[0]
                materials.add(name)
            what = f"{word} {kind}"
            assert what in TAKES, f"{what}: not of pbrt's"
            assert set(takes) <= set(TAKES[what]), f"{what} takes no {set(takes) - set(TAKES[what])}"
            assert in_world == (word not in ("Camera", "Film", "PixelFilter", "Sampler", "Integrator")), f"{what}: wrong side of WorldBegin"
            for part in takes.get("string materials", []):
                assert part in materials, f"{name}: no material {part}"
            if what == "Shape plymesh":
                assert os.path.exists(os.path.join(os.path.dirname(path), takes["string filename"][0])), takes
            shapes += word == "Shape"
        assert depth in (0, 1)
    assert depth == 0 and in_world and shapes, "not closed, or empty"


wrong = 0
for file in sys.argv[1:]:
    try:
        check(file)
    except (AssertionError, ValueError, IndexError, KeyError) as error:
        print(f"{file}: {error!r}")
        wrong += 1
sys.exit(wrong > 0)
