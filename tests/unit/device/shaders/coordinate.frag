// Where the rasteriser says that the texel is.
#version 450

layout(location = 0) out vec4 position_px;

void main() { position_px = vec4(gl_FragCoord.xy, -1.0, 0.5); }
