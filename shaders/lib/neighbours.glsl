// Walks over the neighbour list that the stage `neighbours` made:
//   for_each_neighbour(i, entry) { uint j = index[entry]; vec2 dW = gradient_of(entry); ... }
// Macros, so that a stage declares only what it reads. A slice's gradients are its x components and then its y
// components, 16 by 16.

#define for_each_neighbour(i, entry)                                           \
  uvec2 list_i = load(list, i);                                                \
  for (uint entry = list_i.x, last_entry = entry + slice_width * list_i.y;     \
       entry != last_entry; entry += slice_width)

#define gradient_of(entry)                                    \
  vec2(load(gradient, 2u * (entry) - (entry) % slice_width),   \
       load(gradient, 2u * (entry) - (entry) % slice_width + slice_width))
