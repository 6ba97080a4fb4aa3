// The march of texel_march.frag in HLSL and in another convention again: a view space that looks along +z, whose depth is
// told as view z of the other sign, and whole texels as the answer.
Texture2D<float> ViewZ : register(t0);
Texture2D Normals : register(t1);

cbuffer March : register(b0) {
  float2 Viewport;
  float2 Focal;
  float2 Principal;
  float NearPlane;
  float Thickness;
  float Reach;
};

static const float kSky = 1e29;

float depthAt(int2 texel) { return -ViewZ.Load(int3(texel, 0)); }

float4 main(float4 position : SV_Position) : SV_Target0 {
  int2 self = int2(position.xy);
  float depth = depthAt(self);
  if (depth > kSky) {
    return float4(0, 0, 0, 0);
  }
  float3 normal = normalize(Normals.Load(int3(self, 0)).xyz);
  float2 from = float2(self) + 0.5;
  float3 origin = float3((from - Principal) / Focal * depth, depth);
  float3 dir = reflect(normalize(origin), normal);
  float len = min(Reach, 1000.0);
  if (origin.z + dir.z * len < NearPlane) {
    len = (NearPlane - origin.z) / dir.z;
  }
  float3 end = origin + dir * len;
  float2 way = Focal * (end.xy / end.z) + Principal - from;
  float2 perTexel = 1.0 / max(abs(way), 1e-9);
  int2 turn = int2(way.x < 0.0 ? -1 : 1, way.y < 0.0 ? -1 : 1);
  int2 texel = self;
  float t = 0.0;
  int looked = 0;
  for (int i = 0; i < 8192; ++i) {
    float2 edges = (abs(float2(texel - self)) + 0.5) * perTexel;
    float tOut = min(min(edges.x, edges.y), 1.0);
    if (i > 0) {
      float surface = depthAt(texel);
      float a = 1.0 / lerp(1.0 / depth, 1.0 / end.z, t);
      float b = 1.0 / lerp(1.0 / depth, 1.0 / end.z, tOut);
      ++looked;
      if (max(a, b) >= surface && min(a, b) < surface + Thickness) {
        return float4(float2(texel), looked, 1);
      }
    }
    texel += edges.x <= edges.y ? int2(turn.x, 0) : int2(0, turn.y);
    bool isOutside = any(texel < int2(0, 0)) || any(texel >= int2(Viewport));
    if (tOut >= 1.0 || isOutside) {
      break;
    }
    t = tOut;
  }
  return float4(0, 0, looked, 0);
}
