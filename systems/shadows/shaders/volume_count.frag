#version 450 core
// Nothing but depth and stencil.

void main() {}
