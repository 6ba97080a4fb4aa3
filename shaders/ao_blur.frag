// One direction of the blur that takes the noise of 4 x 4 pixels out of ao_noisy: five texels, the outer two by half,
// so that each of the pattern's four columns counts the same.
//
// A neighbour counts where its depth is the one that the pixel's plane has there: 1 / dist_view is linear over a
// plane's image (docs/spaces.md), so the neighbour k steps away should have the pixel's own plus k times the slope.
// The slope is that of the side whose two texels lie the straighter, or 0 where neither does, as on a pole one texel
// wide. So a floor seen at a grazing angle is blurred along its whole length, and nothing across an edge.
// In: ao_noisy (by the row: what the first direction wrote), r visibility, g dist_view. Out: the same, blurred;
// background is left as it is. The result is the pixel's own value and a mean of differences to it: a constant image
// keeps its bits.
#version 450

layout(std140, binding = 0) uniform AoBlurBlock {
  vec2 size_px;
  vec2 texel_uv;
  int ao_blur_down;  // 0: along rows, 1: along columns
};

layout(binding = 1) uniform sampler2D ao_noisy;

layout(location = 0) out vec2 ao;

const float SAME_PLANE = 0.02;  // relative: of 1 / dist_view, for two steps

vec2 load(vec2 texel) { return textureLod(ao_noisy, (texel + 0.5) * texel_uv, 0.0).xy; }

// The neighbour's difference to the pixel and its weight, 0 outside the image.
vec2 counted(vec2 beside, float steps, vec2 own, float inv_dist, float slope, bool is_inside, float weight) {
  float off = abs(1.0 / beside.y - (inv_dist + steps * slope));
  return is_inside && off <= SAME_PLANE * inv_dist ? weight * vec2(beside.x - own.x, 1.0) : vec2(0.0);
}

void main() {
  vec2 texel = floor(gl_FragCoord.xy);
  vec2 along = ao_blur_down != 0 ? vec2(0.0, 1.0) : vec2(1.0, 0.0);
  float place = ao_blur_down != 0 ? texel.y : texel.x;
  float last = (ao_blur_down != 0 ? size_px.y : size_px.x) - 1.0;
  vec2 own = load(texel);
  if (isinf(own.y)) {
    ao = own;
    return;
  }
  vec2 before2 = load(texel - 2.0 * along);
  vec2 before = load(texel - along);
  vec2 after = load(texel + along);
  vec2 after2 = load(texel + 2.0 * along);
  float inv_dist = 1.0 / own.y;
  float slope_before = inv_dist - 1.0 / before.y;
  float slope_after = 1.0 / after.y - inv_dist;
  // How far the second texel is off the line through the pixel and the first.
  float bend_before = place > 1.0 ? abs((1.0 / before.y - 1.0 / before2.y) - slope_before) : 1e30;
  float bend_after = place < last - 1.0 ? abs((1.0 / after2.y - 1.0 / after.y) - slope_after) : 1e30;
  float slope = bend_before < bend_after ? slope_before : slope_after;
  slope = min(bend_before, bend_after) <= SAME_PLANE * inv_dist ? slope : 0.0;
  vec2 sum = counted(before2, -2.0, own, inv_dist, slope, place > 1.0, 0.5) +
             counted(before, -1.0, own, inv_dist, slope, place > 0.0, 1.0) +
             counted(after, 1.0, own, inv_dist, slope, place < last, 1.0) +
             counted(after2, 2.0, own, inv_dist, slope, place < last - 1.0, 0.5);
  ao = vec2(own.x + sum.x / (1.0 + sum.y), own.y);
}
