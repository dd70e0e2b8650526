// Cells of the grid; twin of cell_of in core/params.hpp.

uint cell_along(float offset, uint padded) {
  float last = float(padded - 3u);
  precise float t = offset * params.inverse_cell;
  t = t > 0.0 ? t : 0.0;  // NaN goes to the first cell
  t = t < last ? t : last;
  return uint(t) + 1u;
}

/// Cell of position x, padding included; positions outside the grid belong to its outermost cells.
uint cell_of(vec2 x) {
  precise vec2 offset = x - params.origin;
  return cell_along(offset.y, params.rows) * params.columns + cell_along(offset.x, params.columns);
}
