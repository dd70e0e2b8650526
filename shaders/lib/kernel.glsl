// Cubic spline kernel in two dimensions and its gradient; twin of cpu/kernel.hpp. q = r/H, (z)_+ = max(z, 0):
//   W  = 5/(14 pi H^2) ((2-q)_+^3 - 4 (1-q)_+^3)
//   dW = 5/(14 pi H^3) (-3 (2-q)_+^2 + 12 (1-q)_+^2) x_ij/r, zero at r = 0

#include "lib/vectors.glsl"

/// W at distance r; 1/length^2.
float kernel(float r) {
  precise float q = r * params.inverse_H;
  precise float t1 = max(1.0 - q, 0.0);
  precise float t2 = max(2.0 - q, 0.0);
  precise float W = params.kernel_factor * (t2 * t2 * t2 - 4.0 * (t1 * t1 * t1));
  return W;
}

/// dW with respect to x_i for x_ij = x_i - x_j of length r; 1/length^3.
vec2 kernel_gradient(vec2 x_ij, float r) {
  precise float q = r * params.inverse_H;
  precise float t1 = max(1.0 - q, 0.0);
  precise float t2 = max(2.0 - q, 0.0);
  precise float inverse_r = r > 0.0 ? 1.0 / r : 0.0;
  precise float slope = params.gradient_factor * (12.0 * (t1 * t1) - 3.0 * (t2 * t2));
  precise vec2 dW = (slope * inverse_r) * x_ij;
  return dW;
}
