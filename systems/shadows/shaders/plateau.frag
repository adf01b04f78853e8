#version 450 core
// The part of the light that a plateau's skirt blocks.

in float dark;

layout(location = 0) out float blocked;

void main() {
    blocked = dark;
}
