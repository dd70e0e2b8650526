// A GPU backend on its own, without a simulator: fields go in, stages run, fields come out.
#pragma once

#include <memory>
#include <optional>
#include <set>
#include <utility>
#include <vector>

#include "gpu/backend.hpp"
#include "gpu/context.hpp"
#include "sluice/scene.hpp"

namespace sluice::test {

struct Gpu {
  gpu::Context context;
  std::unique_ptr<gpu::GpuBackend> backend;
  Sizes sizes;

  explicit Gpu(const gpu::BackendOptions& options = {}, gpu::ShaderLibrary shaders = gpu::ShaderLibrary())
      : context(std::nullopt, std::move(shaders)), backend(gpu::make_backend(context, options)) {}

  void allocate(FieldSet fields, const Sizes& with) { backend->allocate(fields, sizes = with); }
  void resize_list(uint64_t entries) { backend->resize_list(sizes.list = entries); }

  /// A whole field; vectors are interleaved.
  std::vector<uint32_t> integers(Field field) const;
  std::vector<double> reals(Field field) const;
};

/// Everything that finds neighbours, on the GPU: the stages from grid_count to neighbours.
struct GpuSearch : Gpu {
  Params params;

  /// Ids are the places in `positions` unless given.
  GpuSearch(const Scene& scene, const std::vector<Vec2>& positions, std::vector<uint32_t> ids = {},
            uint64_t list_entries = 0, const gpu::BackendOptions& options = {});

  void grid();  ///< grid_count to reorder
  void run();   ///< all of them

  uint32_t list_needed() const { return integers(Field::list_needed).at(0); }
  /// Entries of all lists together.
  uint64_t entries() const;
  /// Neighbours of each particle in cell order, as the lists have them.
  std::vector<std::vector<uint32_t>> lists() const;
  /// Neighbour ids of each particle, by id.
  std::vector<std::set<uint32_t>> neighbour_sets() const;
};

}  // namespace sluice::test
