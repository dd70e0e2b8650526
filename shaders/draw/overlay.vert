#version 430 core
// One rectangle of the overlay per instance: a glyph cut from the font's texture, or a plain area.
// Pixel coordinates have their origin at the picture's top left corner, y down.

in vec4 box;   // left, top, right, bottom in pixels
in vec4 cut;   // the same in the texture, from 0 to 1; all 0 for a plain area
in vec4 tint;

uniform vec2 picture;  // size in pixels

out vec2 texture_position;
flat out vec4 fill;
flat out int plain;

void main() {
  vec2 corner = vec2(gl_VertexID & 1, gl_VertexID >> 1);
  texture_position = mix(cut.xy, cut.zw, corner);
  fill = tint;
  plain = cut.zw == vec2(0.0) ? 1 : 0;
  gl_Position = vec4(mix(box.xy, box.zw, corner) / picture * 2.0 - 1.0, 0.0, 1.0);
}
