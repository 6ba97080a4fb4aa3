// A march through every texel on the ray's way, in conventions that are not the kit's: reversed depth from 1 at the near
// plane to 0 at the far one, normals packed into 0..1, texture coordinates that grow upwards.
#version 450

layout(std140, binding = 0) uniform March {
  vec2 viewport;   // texels
  vec2 focal;      // texels per unit of x / z
  vec2 principal;  // the texel position of the image's middle
  float zNear;
  float zFar;
  float thickness;
  float reach;
};

layout(binding = 1) uniform sampler2D depthTex;
layout(binding = 2) uniform sampler2D normalTex;

layout(location = 0) out vec4 result;  // uv, lookups, 1 for a hit

const float kSky = 1e30;

float linearDepth(ivec2 texel) {
  float stored = texelFetch(depthTex, texel, 0).r;
  return stored == 0.0 ? kSky : zNear * zFar / (zNear + stored * (zFar - zNear));
}

void main() {
  result = vec4(0.0);
  ivec2 self = ivec2(gl_FragCoord.xy);
  float depth = linearDepth(self);
  if (depth == kSky) {
    return;
  }
  vec3 normal = normalize(texelFetch(normalTex, self, 0).xyz * 2.0 - 1.0);
  vec2 from = vec2(self) + 0.5;
  vec3 origin = vec3((from - principal) / focal * depth, -depth);
  vec3 dir = reflect(normalize(origin), normal);
  float len = min(reach, 1000.0);
  if (origin.z + dir.z * len > -zNear) {
    len = (-zNear - origin.z) / dir.z;
  }
  vec3 end = origin + dir * len;
  vec2 way = focal * (end.xy / -end.z) + principal - from;
  float invFrom = 1.0 / depth;
  float invTo = 1.0 / -end.z;
  vec2 perTexel = 1.0 / max(abs(way), 1e-9);
  ivec2 turn = ivec2(way.x < 0.0 ? -1 : 1, way.y < 0.0 ? -1 : 1);
  ivec2 texel = self;
  float t = 0.0;
  int looked = 0;
  for (int i = 0; i < 8192; ++i) {
    vec2 edges = (abs(vec2(texel - self)) + 0.5) * perTexel;
    float tOut = min(min(edges.x, edges.y), 1.0);
    if (i > 0) {
      float surface = linearDepth(texel);
      float a = 1.0 / mix(invFrom, invTo, t);
      float b = 1.0 / mix(invFrom, invTo, tOut);
      ++looked;
      if (max(a, b) >= surface && min(a, b) < surface + thickness) {
        vec2 uv = (vec2(texel) + 0.5) / viewport;
        result = vec4(uv.x, 1.0 - uv.y, float(looked), 1.0);
        return;
      }
    }
    texel += edges.x <= edges.y ? ivec2(turn.x, 0) : ivec2(0, turn.y);
    bool isOutside = texel.x < 0 || texel.y < 0 || texel.x >= int(viewport.x) || texel.y >= int(viewport.y);
    if (tOut >= 1.0 || isOutside) {
      break;
    }
    t = tOut;
  }
  result.z = float(looked);
}
