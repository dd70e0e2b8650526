// Cells of the grid; twin of cell_of in core/model/params.hpp.

uint cell_along(float at, uint padded) {
  float last = float(padded - 3u);
  precise float t = at * params.inverse_cell;
  t = t > 0.0 ? t : 0.0;  // NaN goes to the first cell
  t = t < last ? t : last;
  return uint(t) + 1u;
}

/// Cell of position x, padding included; positions outside the grid belong to its outermost cells.
uint cell_of(vec2 x) {
  return cell_along(x.y, params.rows) * params.columns + cell_along(x.x, params.columns);
}
