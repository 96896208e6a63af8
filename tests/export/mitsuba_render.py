"""Renders an exported scene with Mitsuba 3: mitsuba_render.py SCENE.xml OUT.pfm [OUT.exr]. Or has it read a picture: mitsuba_render.py IN.exr OUT.pfm"""
import sys

import mitsuba

mitsuba.set_variant("scalar_rgb")
if sys.argv[1].endswith(".xml"):
    picture = mitsuba.Bitmap(mitsuba.render(mitsuba.load_file(sys.argv[1])))
else:
    picture = mitsuba.Bitmap(sys.argv[1])
for out in sys.argv[2:]:
    picture.write(out)
