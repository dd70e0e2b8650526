// How the mean density of a resting fluid settles: the four runs of [Hunkler 2022, Figs. 6.9 to 6.12].
#pragma once

#include <vector>

#include "studies/study.hpp"

namespace sluice::study {

std::vector<Point> density_points();
Report density_report(const std::vector<Result>& results);

}  // namespace sluice::study
