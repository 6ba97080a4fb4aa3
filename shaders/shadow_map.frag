// Depth of casters without an alpha cutoff: the rasteriser writes it.
#version 450

void main() {}
