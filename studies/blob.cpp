// Sums over particles, and interpolation between frames.
#include "studies/blob.hpp"

#include <algorithm>
#include <cmath>

#include "media/recording.hpp"
#include "studies/study.hpp"

namespace sluice::study {
namespace {

constexpr size_t points = 4;

/// The polynomial of third degree through the frames from `first` on.
double cubic(double time, size_t first, const std::vector<double>& times, const std::vector<double>& values) {
  double sum = 0;
  for (size_t i = first; i < first + points; ++i) {
    double term = values[i];
    for (size_t j = first; j < first + points; ++j)
      if (j != i) term *= (time - times[j]) / (times[i] - times[j]);
    sum += term;
  }
  return sum;
}

/// The first of four frames, two on either side of the gap behind frame `i` where there are so many.
size_t first_around(size_t i, size_t size) { return std::min(i == 0 ? 0 : i - 1, size - points); }

}  // namespace

Blob blob_of(double time, const Snapshot& state) {
  const auto count = static_cast<double>(state.x.size());
  Blob blob{.time = time};
  for (size_t i = 0; i < state.x.size(); ++i) {
    const Vec2 x = state.x[i], v = state.v[i];
    blob.centre += x;
    blob.velocity += v;
    blob.kinetic += glm::dot(v, v) / 2;
    blob.distance_squared += glm::dot(x, x);
    blob.angular_momentum += x.x * v.y - x.y * v.x;
  }
  blob.centre /= count;
  blob.velocity /= count;
  blob.kinetic /= count;
  blob.distance_squared /= count;
  blob.angular_momentum /= count;
  Vec2 moments{};
  for (const Vec2& x : state.x) moments += (x - blob.centre) * (x - blob.centre);
  blob.semi_axes = 2.0 * glm::sqrt(moments / count);
  return blob;
}

std::vector<Blob> blobs_of(const std::filesystem::path& path) {
  const media::Recording recording(path);
  std::vector<Blob> blobs;
  for (size_t frame = 0; frame < recording.frames(); ++frame) {
    const media::Moment moment = recording.moment(frame);
    if (blobs.empty() || moment.report.time > blobs.back().time)
      blobs.push_back(blob_of(moment.report.time, moment.state));
  }
  return blobs;
}

double value_at(double time, const std::vector<double>& times, const std::vector<double>& values) {
  if (times.size() < points) return unknown_number;
  const auto after = static_cast<size_t>(std::ranges::upper_bound(times, time) - times.begin());
  return cubic(time, first_around(after == 0 ? 0 : after - 1, times.size()), times, values);
}

double zero_after(size_t i, const std::vector<double>& times, const std::vector<double>& values) {
  const size_t first = first_around(i, times.size());
  double low = times[i], high = times[i + 1];
  for (int halving = 0; halving < 60; ++halving) {
    const double middle = (low + high) / 2;
    ((cubic(middle, first, times, values) < 0) == (values[i] < 0) ? low : high) = middle;
  }
  return (low + high) / 2;
}

}  // namespace sluice::study
