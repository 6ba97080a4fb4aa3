// What a depth-buffer read costs when the next one waits for it and when none does, as loops that nothing can shorten:
// each returns a number that follows from the images alone, so that a read left out would be noticed.
//
// Needs: float load_dist_view(vec2 texel)    metres; over 0 in every G-buffer, which no compiler can know
#ifndef ROOFLINE_FETCH_GLSL
#define ROOFLINE_FETCH_GLSL

// `count` reads along a row, each from where the one before sends it: one texel on, two where it is below 0; from the
// right edge on to the left one. Returns the texels gone: `count` in every G-buffer.
float roofline_dependent_fetches(vec2 texel, float width_px, int count) {
  float gone_px = 0.0;
  for (int i = 0; i < count; ++i) {
    float step_px = load_dist_view(texel) < 0.0 ? 2.0 : 1.0;
    gone_px += step_px;
    texel.x += step_px;
    texel.x -= texel.x >= width_px ? width_px : 0.0;
  }
  return gone_px;
}

// `count` reads of the texels of a row, one after the other, from the right edge on to the left one. Returns how many
// are not below 0: `count` in every G-buffer.
float roofline_independent_fetches(vec2 texel, float width_px, int count) {
  float found = 0.0;
  for (int i = 0; i < count; ++i) {
    found += load_dist_view(texel) < 0.0 ? 0.0 : 1.0;
    texel.x += 1.0;
    texel.x -= texel.x >= width_px ? width_px : 0.0;
  }
  return found;
}

#endif
