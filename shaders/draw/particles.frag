#version 430 core
// Fills a particle's circle. The opacity of a pixel is the part of its area that the circle covers, found by cutting
// the pixel into eight rows and intersecting each with the circle's chord at that height.

flat in vec2 centre;  // in pixels
flat in vec3 colour;

uniform float radius;   // in pixels; 0 fills the whole quad
uniform float opacity;  // below 1 for circles that were enlarged to a pixel

out vec4 result;

float row_sum(vec4 y, float x) {
  vec4 chord = sqrt(max(radius * radius - y * y, 0.0));
  vec4 inside = clamp(min(vec4(x + 0.5), chord) - max(vec4(x - 0.5), -chord), 0.0, 1.0);
  return inside.x + inside.y + inside.z + inside.w;
}

void main() {
  float coverage = 1.0;
  if (radius > 0.0) {
    vec2 distance = abs(gl_FragCoord.xy - centre);
    const vec4 rows = vec4(1.0, 3.0, 5.0, 7.0) / 16.0;
    coverage = (row_sum(distance.y - rows, distance.x) + row_sum(distance.y + rows, distance.x)) / 8.0;
  }
  result = vec4(colour, coverage * opacity);
}
