#version 430 core
// Text and plain areas of the overlay; the font's texture holds opacity.

in vec2 texture_position;
flat in vec4 fill;
flat in int plain;

uniform sampler2D font;

out vec4 result;

void main() {
  float ink = texture(font, texture_position).r;
  result = vec4(fill.rgb, fill.a * (plain == 1 ? 1.0 : ink));
}
