#version 430 core
// Writes the last word of a buffer, to see whether shaders reach so far.

layout(local_size_x = 1) in;
layout(std430) writeonly buffer probe_block { uint words[]; };
uniform uint last;
uniform uint mark;

void main() {
  words[last] = mark;
}
