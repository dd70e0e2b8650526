// The shapes of a checked scene tree, [[fluid.*]] and [[boundary.*]], as values in numbers.
#pragma once

#include <utility>
#include <vector>

#include "core/scene/scene.hpp"
#include "core/scene/tree.hpp"

namespace sluice {

/// Reads lengths and shapes, and keeps the samples of all shapes read within what can be numbered. All throw
/// InputError.
class ShapeReader {
 public:
  /// `spacing` is the value of particles.spacing; it must outlive the reader.
  explicit ShapeReader(const SceneValue& spacing) : spacing_(spacing), h_(spacing.number) {}

  /// All shapes of a [fluid] or a [boundary] table in the order of the file.
  std::vector<FluidShape> fluid(const SceneValue& table);
  std::vector<BoundaryShape> boundary(const SceneValue& table);

  /// The value of a point [x, y].
  Vec2 point(const SceneValue& value) const { return {length(value.items[0]), length(value.items[1])}; }

  /// The points `min` and `max` of a table, of which `max` has to be beyond it both ways, and when asked not
  /// infinitely far.
  std::pair<Vec2, Vec2> box(const SceneValue& table, bool finite = false) const;

 private:
  template <class Shape>
  std::vector<Shape> shapes(const SceneValue& parent);
  double length(const SceneValue& value) const;
  Rect rect(const SceneValue& table);
  Disc disc(const SceneValue& table);
  Polygon polygon(const SceneValue& table, bool needs_centre);
  Container container(const SceneValue& table);
  Segment segment(const SceneValue& table);
  void add_samples(const SceneValue& table, double count);

  const SceneValue& spacing_;
  double h_;
  double samples_ = 0;  ///< so far; an upper bound for discs and polygons
};

/// The value of a checked [x, y] of numbers.
Vec2 numbers(const SceneValue& pair);

}  // namespace sluice
