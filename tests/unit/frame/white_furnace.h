// The furnace that lighting and composites are held to: what loses nothing shows nothing but its radiance.
#pragma once

namespace ssrkit {

inline constexpr double kFurnace = 0.75;

}  // namespace ssrkit
