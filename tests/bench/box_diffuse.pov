#include "box.inc"
global_settings { assumed_gamma 1 max_trace_level 16 Radiosity() }
Lamp(false)
sphere { <-0.42, -0.65, -0.30>, 0.35 pigment { rgb 0.73 } }
sphere { <0.40, -0.65, 0.25>, 0.35 pigment { rgb 0.73 } }
