// The shapes of a checked scene tree, [[fluid.*]] and [[boundary.*]], as values in numbers.
#pragma once

#include <initializer_list>
#include <vector>

#include "core/scene/scene.hpp"
#include "core/scene/tree.hpp"

namespace sluice {

/// A table of the tree.
struct ScenePlace {
  const SceneValue* table;
  std::string path;       ///< in this scene: "fluid.rect.0"
  std::string kind = "";  ///< of a shape: "rect"

  const SceneValue& operator[](std::string_view name) const { return table->at(name); }
  /// The error for a key of this table, at the place to `blame` among the values that take part.
  InputError refusal(std::string_view name, std::initializer_list<const SceneValue*> parts,
                     const std::string& found, const std::string& expected) const;
};

/// Reads lengths and shapes, and keeps the samples of all shapes read within what can be numbered. All throw
/// InputError.
class ShapeReader {
 public:
  /// `spacing` is the value of particles.spacing; it must outlive the reader.
  explicit ShapeReader(const SceneValue& spacing) : spacing_(spacing), h_(spacing.number) {}

  /// All shapes of a [fluid] or a [boundary] table in the order of the file.
  std::vector<FluidShape> fluid(const SceneValue& table);
  std::vector<BoundaryShape> boundary(const SceneValue& table);

  /// The point [x, y] of a key.
  Vec2 point(const ScenePlace& place, std::string_view name) const;

  /// The points `min` and `max`, which has to be beyond it both ways, and when asked not infinitely far.
  std::pair<Vec2, Vec2> box(const ScenePlace& place, bool finite = false) const;

 private:
  template <class Shape>
  std::vector<Shape> shapes(const SceneValue& table, const std::string& path);

  double length(const SceneValue& value, const std::string& path) const;
  Vec2 point(const SceneValue& value, const std::string& path) const;
  Rect rect(const ScenePlace& place);
  Disc disc(const ScenePlace& place);
  Polygon polygon(const ScenePlace& place, bool needs_centre);
  Container container(const ScenePlace& place);
  Segment segment(const ScenePlace& place);
  void add_samples(const ScenePlace& place, double count);

  const SceneValue& spacing_;
  double h_;
  double samples_ = 0;  ///< so far; an upper bound for discs and polygons
};

/// The place to name for a mistake in which several values take part: the first that was overridden, else the
/// first that was written, else the first.
const std::string& blame(std::initializer_list<const SceneValue*> values);

/// The value of a checked [x, y] of numbers.
Vec2 numbers(const SceneValue& pair);

}  // namespace sluice
