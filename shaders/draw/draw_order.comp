#version 430 core
// What a picture draws of the fluid, from a backend's buffers: in the order of ids instead of cells, so that circles
// cover each other the same way in every picture, with positions from the domain's corner and the values that
// colours stand for. In double and with the same operations as pictures of the CPU backend, for the same bytes.

layout(local_size_x = 64) in;

layout(std430) restrict readonly buffer id_block { uint id[]; };
layout(std430) restrict readonly buffer x_block { vec2 x[]; };
layout(std430) restrict readonly buffer quantity_block { float quantity[]; };  // of vectors the components in turn
layout(std430) restrict writeonly buffer position_block { vec2 position[]; };
layout(std430) restrict writeonly buffer value_block { float value[]; };
layout(std430) restrict buffer largest_block { uint largest; };  // positive floats are in order as integers

uniform uint count;
uniform bool of_vectors;  // the quantity is the length of vectors
uniform double unit;      // value = unit * quantity

double length_of(dvec2 a) {
  precise double square = a.x * a.x + a.y * a.y;
  return sqrt(square);
}

void main() {
  uint i = (gl_WorkGroupID.y * gl_NumWorkGroups.x + gl_WorkGroupID.x) * gl_WorkGroupSize.x + gl_LocalInvocationIndex;
  if (i >= count) return;
  position[id[i]] = x[i];
  double amount = of_vectors ? length_of(dvec2(quantity[2u * i], quantity[2u * i + 1u])) : double(quantity[i]);
  float value_i = float(unit * amount);
  value[id[i]] = value_i;
  if (value_i > uintBitsToFloat(largest)) atomicMax(largest, floatBitsToUint(value_i));
}
