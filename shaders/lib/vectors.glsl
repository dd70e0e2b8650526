// Vector functions with a fixed order of operations. The built-in ones leave it to the driver, and these are to give
// the same bits as the CPU backend.

float dot_of(vec2 a, vec2 b) {
  precise float sum = a.x * b.x + a.y * b.y;
  return sum;
}

float length_of(vec2 a) {
  precise float root = sqrt(dot_of(a, a));
  return root;
}

/// The larger of two values; keeps a NaN in either place; twin of core/model/larger.hpp. max() may hide NaN, and so may
/// `a < b ? b : a`, of which Mesa makes a max().
float larger(float a, float b) {
  return b > a || isnan(b) ? b : a;
}
