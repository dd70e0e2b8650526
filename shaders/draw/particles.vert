#version 430 core
// Places one particle as a point sprite or as a quad (four vertices of one instance) and chooses its colour.
// Pixel coordinates have their origin at the picture's top left corner, y down.

in vec2 position;   // relative to the lower left corner of the view
in float value;     // |v| dt/h, rho/rho0 or p; not read for the boundary

uniform vec2 origin;       // pixel of position (0, 0)
uniform vec2 scale;        // pixels per unit; the y component is negative
uniform vec4 viewport;     // x, y, width, height in pixels
uniform vec2 half_extent;  // of the sprite or quad, in pixels
uniform bool quads;
uniform int colouring;     // 0 boundary, 1 speed, 2 map
uniform vec2 value_range;  // what the map's ends stand for

flat out vec2 centre;
flat out vec3 colour;

const vec3 boundary_grey = vec3(0.62);

// Nine stops of the map "viridis" (S. van der Walt, N. Smith; CC0): even steps in lightness.
const vec3 stops[9] = vec3[9](
    vec3(0.267, 0.005, 0.329), vec3(0.279, 0.175, 0.483), vec3(0.230, 0.322, 0.546),
    vec3(0.173, 0.449, 0.558), vec3(0.128, 0.567, 0.551), vec3(0.158, 0.684, 0.502),
    vec3(0.369, 0.789, 0.383), vec3(0.678, 0.864, 0.190), vec3(0.993, 0.906, 0.144));

// Equation 5.27 of [Hunkler 2022]: blue at rest, green at half a spacing per step, red from a whole one on.
vec3 speed_colour(float s) {
  if (!(s < 1.0)) return vec3(1.0, 0.0, 0.0);
  float sine = sin(3.14159265 * s);
  float rising = sine * sine;
  float falling = 1.0 - rising;
  return s < 0.5 ? vec3(0.0, rising, falling) : vec3(falling, rising, 0.0);
}

vec3 map_colour(float t) {
  float x = clamp(t, 0.0, 1.0) * 8.0;
  int lower = min(int(x), 7);
  return mix(stops[lower], stops[lower + 1], x - float(lower));
}

void main() {
  centre = origin + scale * position;
  vec2 pixel = centre;
  if (quads) pixel += half_extent * vec2((gl_VertexID & 1) * 2 - 1, (gl_VertexID >> 1) * 2 - 1);
  gl_Position = vec4((pixel - viewport.xy) / viewport.zw * 2.0 - 1.0, 0.0, 1.0);
  gl_PointSize = 2.0 * half_extent.x;
  if (colouring == 0) {
    colour = boundary_grey;
  } else if (colouring == 1) {
    colour = speed_colour(value);
  } else {
    float width = value_range.y - value_range.x;
    colour = map_colour(width > 0.0 ? (value - value_range.x) / width : 0.5);
  }
}
