// Reads the image at uv = p_px * uv_per_px + uv_offset on one level; alpha tells the size that the shader sees.
#version 450

layout(binding = 0) uniform sampler2D image;
layout(binding = 1, std140) uniform Place {
  vec2 uv_per_px;
  vec2 uv_offset;
  float level;
};

layout(location = 0) out vec4 result;

void main() {
  vec3 value = textureLod(image, gl_FragCoord.xy * uv_per_px + uv_offset, level).rgb;
  result = vec4(value, float(textureSize(image, 0).x));
}
