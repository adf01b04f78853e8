#version 450 core
// Depth and stencil are all that is wanted.

void main() {}
