// The shapes of a checked scene tree, [[fluid.*]] and [[boundary.*]], as values in numbers.
#pragma once

#include <initializer_list>
#include <vector>

#include "core/scene/scene.hpp"
#include "core/scene/tree.hpp"

namespace sluice {

/// Reads shapes, counts their samples, and keeps the sum over all shapes read within what can be numbered.
class ShapeReader {
 public:
  /// `spacing` is the value of particles.spacing; it must outlive the reader.
  explicit ShapeReader(const SceneValue& spacing) : spacing_(spacing), h_(spacing.number) {}

  /// All shapes of a [fluid] table in the order of the file. Throws InputError.
  std::vector<FluidShape> fluid(const SceneValue& table);

  /// All shapes of a [boundary] table in the order of the file. Throws InputError.
  std::vector<BoundaryShape> boundary(const SceneValue& table);

  /// The point [x, y] of a key. Throws InputError when it isn't finite.
  Vec2 point(const SceneValue& value, const std::string& path) const;

 private:
  struct Place {
    const SceneValue* table;
    std::string kind;  ///< "rect"
    std::string path;  ///< "fluid.rect.0"
  };
  static std::vector<Place> places(const SceneValue& table, const std::string& path);

  double length(const SceneValue& value, const std::string& path) const;
  Rect rect(const Place& place);
  Disc disc(const Place& place);
  Polygon polygon(const Place& place);
  Polygon fluid_polygon(const Place& place);  ///< one with a centre of area
  Container container(const Place& place);
  Segment segment(const Place& place);
  void add_samples(const Place& place, double count);

  const SceneValue& spacing_;
  double h_;
  double samples_ = 0;  ///< so far; an upper bound for discs and polygons
};

/// The place to name for a mistake in which several values take part: the first that was overridden, else the
/// first that was written, else the first.
const std::string& blame(std::initializer_list<const SceneValue*> values);

/// The value of a checked [x, y] of numbers.
Vec2 numbers(const SceneValue& pair);

/// "(x, y)" for messages.
std::string describe(Vec2 point);

}  // namespace sluice
