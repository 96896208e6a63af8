#include "box.inc"
global_settings {
    assumed_gamma 1 max_trace_level 16 Radiosity()
    photons { count 200000 autostop 0 jitter 0.4 max_trace_level 16 }
}
Lamp(true)
sphere {
    <-0.42, -0.65, -0.30>, 0.35
    pigment { rgb 0 }
    finish { diffuse 0 reflection { 1 } }
    photons { target reflection on collect off }
}
sphere {
    <0.40, -0.65, 0.25>, 0.35
    pigment { rgbf <1, 1, 1, 1> }
    finish { diffuse 0 reflection { 0, 1 fresnel on } conserve_energy }
    interior { ior 1.5 }
    photons { target reflection on refraction on collect off }
}
