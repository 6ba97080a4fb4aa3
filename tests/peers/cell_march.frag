// A march through the mips of the nearest depths: over a cell that the ray passes before, and a level up; a level down
// where it does not (Uludag, Hi-Z Screen-Space Cone-Traced Reflections, GPU Pro 5, 2014, sections 4.4.1 and 4.5). In
// reversed window depth, which is linear on the screen: position and depth go along one straight line in t.
#version 450

layout(std140, binding = 0) uniform March {
  vec2 viewport;   // texels
  vec2 focal;      // texels per unit of x / z
  vec2 principal;  // the texel position of the image's middle
  float zNear;
  float zFar;
  float thickness;
  float reach;
  int coarsest;
};

layout(binding = 1) uniform sampler2D depthPyramid;
layout(binding = 2) uniform sampler2D normalTex;

layout(location = 0) out vec4 result;  // texel, lookups, 1 for a hit

float toWindow(float distance) { return zNear * (zFar - distance) / (distance * (zFar - zNear)); }
float toDistance(float window) { return zNear * zFar / (zNear + window * (zFar - zNear)); }
vec3 project(vec3 p) { return vec3(focal * (p.xy / -p.z) + principal, toWindow(-p.z)); }

void main() {
  result = vec4(0.0);
  ivec2 self = ivec2(gl_FragCoord.xy);
  float distance = toDistance(texelFetch(depthPyramid, self, 0).r);
  vec3 normal = normalize(texelFetch(normalTex, self, 0).xyz * 2.0 - 1.0);
  vec2 middle = vec2(self) + 0.5;
  vec3 origin = vec3((middle - principal) / focal * distance, -distance);
  vec3 dir = reflect(normalize(origin), normal);
  float len = min(reach, 1000.0);
  if (origin.z + dir.z * len > -zNear) {
    len = (-zNear - origin.z) / dir.z;
  }
  vec3 from = vec3(middle, toWindow(distance));
  vec3 way = project(origin + dir * len) - from;
  way.xy = mix(way.xy, vec2(1e-9), lessThan(abs(way.xy), vec2(1e-9)));
  vec2 ahead = step(0.0, way.xy);
  vec2 turn = 2.0 * ahead - 1.0;

  vec2 edges = (vec2(self) + ahead - middle) / way.xy;
  float t = min(edges.x, edges.y);
  vec2 cell = vec2(self) + (edges.x <= edges.y ? vec2(turn.x, 0.0) : vec2(0.0, turn.y));
  int level = 0;
  int looked = 0;
  while (t < 1.0 && looked < 8192 && all(greaterThanEqual(cell, vec2(0.0))) &&
         all(lessThan(cell * exp2(float(level)), viewport))) {
    float size = exp2(float(level));
    float surface = texelFetch(depthPyramid, min(ivec2(cell), max(ivec2(viewport) >> level, 1) - 1), level).r;
    ++looked;
    edges = ((cell + ahead) * size - middle) / way.xy;
    float tOut = min(min(edges.x, edges.y), 1.0);
    float a = from.z + t * way.z;
    float b = from.z + tOut * way.z;
    bool reaches = min(a, b) <= surface && surface > 0.0;
    bool isBehind = toDistance(max(a, b)) >= toDistance(surface) + thickness;
    if (reaches && level == 0 && !isBehind) {
      result = vec4(cell, float(looked), 1.0);
      return;
    }
    if (reaches && level > 0) {
      // Down, at the entry: no further, for the last bit's sake.
      --level;
      vec2 middles = ((cell + 0.5) * size - middle) / way.xy;
      cell = 2.0 * cell + mix(1.0 - ahead, ahead, greaterThanEqual(vec2(t), middles));
      continue;
    }
    cell += edges.x <= edges.y ? vec2(turn.x, 0.0) : vec2(0.0, turn.y);
    t = tOut;
    if (level < coarsest && !reaches) {
      ++level;
      cell = floor(0.5 * cell);
    }
  }
  result.z = float(looked);
}
