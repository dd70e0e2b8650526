// A context, a painter and what they refer to.
#include "sluice/pictures.hpp"

#include "core/output/output_file.hpp"
#include "draw/painter.hpp"
#include "gpu/context.hpp"
#include "sluice/sampling.hpp"

namespace sluice::media {

struct Pictures::State {
  State(Scene its_scene, const PictureOptions& its_options)
      : scene(std::move(its_scene)),
        options(its_options),
        samples(sample(scene)),
        painter(context, scene, samples, options.size.value_or(scene.image_size)) {}

  Scene scene;
  PictureOptions options;
  Samples samples;
  gpu::Context context;
  draw::Painter painter;
};

Pictures::Pictures(Scene scene, const PictureOptions& options)
    : state_(std::make_unique<State>(std::move(scene), options)) {}
Pictures::~Pictures() = default;
Pictures::Pictures(Pictures&&) noexcept = default;
Pictures& Pictures::operator=(Pictures&&) noexcept = default;

draw::Image Pictures::draw(const Snapshot& state, double dt) {
  sluice::draw::Frame labels;
  labels.colour = state_->options.colour.value_or(state_->scene.colour);
  labels.colour_bar = state_->options.colour_bar && labels.colour != Colour::speed;
  state_->painter.paint(std::move(labels), dt, state);
  return state_->painter.renderer().read();
}

void write_png(const std::filesystem::path& path, const draw::Image& image) {
  write_file(path, sluice::draw::encode_png(image));
}

}  // namespace sluice::media
