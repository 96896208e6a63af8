"""Renders an exported scene with Mitsuba 3, into a picture that `photonlab diff` reads. Usage: mitsuba_render.py SCENE.xml OUT.pfm"""
import sys

import mitsuba

mitsuba.set_variant("scalar_rgb")
scene = mitsuba.load_file(sys.argv[1])
mitsuba.Bitmap(mitsuba.render(scene)).write(sys.argv[2])
