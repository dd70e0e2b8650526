// A shape of a scene -> the points of its lattice.
#pragma once

#include <vector>

#include "sluice/scene.hpp"

namespace sluice {

/// The points of a shape at spacing h: rows outer (y) and columns inner (x), walls by layers.
std::vector<Vec2> points_of(const Rect& rect, double h);
std::vector<Vec2> points_of(const Disc& disc, double h);
std::vector<Vec2> points_of(const Polygon& polygon, double h);
std::vector<Vec2> points_of(const Points& points, double h);
std::vector<Vec2> points_of(const Container& box, double h);
std::vector<Vec2> points_of(const Segment& segment, double h);

/// At least as many as points_of gives, found without making them.
double count_bound(const Rect& rect, double h);
double count_bound(const Disc& disc, double h);
double count_bound(const Polygon& polygon, double h);
double count_bound(const Points& points, double h);
double count_bound(const Container& box, double h);
double count_bound(const Segment& segment, double h);

/// The middle of a rect's lattice, a disc's centre, a polygon's centre of area; of points it is not asked
/// for.
Vec2 centre_of(const Rect& rect, double h);
Vec2 centre_of(const Disc& disc, double h);
Vec2 centre_of(const Polygon& polygon, double h);
Vec2 centre_of(const Points& points, double h);

}  // namespace sluice
