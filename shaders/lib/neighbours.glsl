// Walks over the neighbour list that the stage `neighbours` made:
//   for_each_neighbour(i, entry) { uint j = index[entry]; vec2 dW = gradient_of(entry); ... }
// Macros, so that a stage declares only what it reads. A slice's gradients are its x components and then its y
// components, 16 by 16.

#define for_each_neighbour(i, entry)                                        \
  for (uint entry = list[i].x, last_entry = entry + slice_width * list[i].y; \
       entry != last_entry; entry += slice_width)

#define gradient_of(entry)                                    \
  vec2(gradient[2u * (entry) - (entry) % slice_width],         \
       gradient[2u * (entry) - (entry) % slice_width + slice_width])
