#version 450

layout(constant_id = 3) const int kInteger = -7;
layout(constant_id = 5) const float kFloat = 0.25;
layout(constant_id = 8) const bool kIsNegated = false;
layout(constant_id = 9) const uint kUnsigned = 11u;

layout(location = 0) out vec4 result;

void main() { result = (kIsNegated ? -1.0 : 1.0) * vec4(kInteger, kFloat, kUnsigned, 1.0); }
