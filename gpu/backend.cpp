// Buffers, transfers, and the dispatches of a stage.
#include "gpu/backend.hpp"

#include <epoxy/gl.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <map>
#include <optional>
#include <stdexcept>

#include "core/text.hpp"
#include "gpu/context.hpp"
#include "gpu/stage_program.hpp"
#include "gpu/storage.hpp"
#include "gpu/timer.hpp"
#include "sluice/error.hpp"

namespace sluice::gpu {
namespace {

constexpr uint32_t guard_word = 0xffffffff;  // NaN as a float

/// Numbers of groups in each dimension, and how many such there are in the buffer of sweep groups.
using GroupNumbers = std::array<uint32_t, 3>;
constexpr auto sweep_group_kinds = static_cast<size_t>(SweepGroups::count);

/// One texel per component.
GLenum texel_format(Field field) { return is_integer(field) ? GL_R32UI : GL_R32F; }

uint32_t limit(GLenum name, GLuint dimension) {
  GLint value = 0;
  glGetIntegeri_v(name, dimension, &value);
  return static_cast<uint32_t>(value);
}

class Implementation final : public GpuBackend {
 public:
  Implementation(const Context& context, const BackendOptions& options)
      : context_(context),
        group_size_(options.group_size > 0 ? options.group_size
                    : context.software()   ? 64
                                           : 128),
        guard_(options.guard),
        timer_(context, options.timed),
        read_back_(context),
        params_(context),
        pass_constants_(context),
        scratch_(context),
        sweep_groups_(context),
        unused_(context) {
    context_.make_current();
    most_groups_ =
        std::min(limit(GL_MAX_COMPUTE_WORK_GROUP_COUNT, 0), limit(GL_MAX_COMPUTE_WORK_GROUP_COUNT, 1));
    if (options.most_groups > 0) most_groups_ = std::min(most_groups_, options.most_groups);
    GLint most_texels = 0;
    glGetIntegerv(GL_MAX_TEXTURE_BUFFER_SIZE, &most_texels);
    most_texels_ = options.most_texels > 0 ? options.most_texels : static_cast<uint32_t>(most_texels);
    GLint alignment = 1;
    glGetIntegerv(GL_UNIFORM_BUFFER_OFFSET_ALIGNMENT, &alignment);
    // A block of std140 is as long as its members, rounded up to that of a vec4.
    const auto each = static_cast<uint32_t>(alignment);
    constants_stride_ = ((sizeof(PassConstants) + 15) / 16 * 16 + each - 1) / each * each;
    free_bytes_ = options.free_bytes;
    make_room(context_, sweep_groups_, sweep_group_kinds * sizeof(GroupNumbers), "sweep groups");
    make_room(context_, unused_, 0, "nothing");
  }

  // The members that follow are deleted with the right context current, whatever was current before.
  ~Implementation() override { context_.make_current(); }
  Implementation(const Implementation&) = delete;
  Implementation& operator=(const Implementation&) = delete;

  void allocate(FieldSet fields, const Sizes& sizes) override {
    context_.make_current();
    if (sizes.cells > most_cells(group_size_)) {
      throw EnvironmentError(fmt::format(
          "a grid of {} cells is more than the GPU backend can sort into, {}; use a smaller domain, a "
          "larger spacing, or --backend cpu",
          sizes.cells, most_cells(group_size_)));
    }
    fields_ = fields;
    sizes_ = sizes;
    for (auto& memory : memory_) memory.reset();
    require_room(fields_);
    use(context_.software() && fits_into_texels() ? Loads::texels : Loads::blocks);
    for_each_field(fields, [&](Field field) { make_field(field); });
    make_room(context_, scratch_, scratch_size(sizes) * sizeof(uint32_t), "scratch");
    plan_passes();
  }

  void resize_list(uint64_t entries) override {
    context_.make_current();
    sizes_.list = entries;
    if (!fits_into_texels()) use(Loads::blocks);
    constexpr FieldSet list{Field::index, Field::gradient};
    for_each_field(list, [&](Field field) { memory_of(field).reset(); });  // before the larger one is made
    require_room(list);
    for_each_field(list, [&](Field field) { make_field(field); });
    plan_passes();
  }

  void configure(const Params& params, const Needs& needs) override {
    context_.make_current();
    if (needs != needs_) forget_current();
    needs_ = needs;
    const std::vector<std::byte> bytes = params_bytes(params);
    glBindBuffer(GL_UNIFORM_BUFFER, params_.name());
    glBufferData(GL_UNIFORM_BUFFER, static_cast<GLsizeiptr>(bytes.size()), bytes.data(), GL_STATIC_DRAW);
  }

  void run(Stage stage) override {
    context_.make_current();
    run(stage, false);
  }

  /// Enqueues all sweeps; the stage `stop_test` sees to it that those after the last one have no groups to
  /// run, itself included.
  void sweep(const std::vector<Stage>& stages, uint32_t times) override {
    context_.make_current();
    const Groups particles = groups_for(sizes_.fluid, group_size_),
                 chunks = groups_for(sizes_.chunks(), group_size_);
    std::array<GroupNumbers, sweep_group_kinds> groups;
    groups.fill({particles.x, particles.y, 1});
    groups[static_cast<size_t>(SweepGroups::chunks)] = {chunks.x, chunks.y, 1};
    groups[static_cast<size_t>(SweepGroups::test)] = groups_of_test(stages);
    glBindBuffer(GL_COPY_WRITE_BUFFER, sweep_groups_.name());
    glBufferSubData(GL_COPY_WRITE_BUFFER, 0, sizeof(groups), groups.data());
    for (uint32_t k = 0; k < times; ++k) {
      for (const Stage stage : stages) run(stage, true);
    }
  }

  void swap(Field a, Field b) override {
    if (info(a).type != info(b).type || info(a).length != info(b).length)
      throw std::logic_error("swap of fields of different types");
    std::swap(memory_of(a), memory_of(b));
  }

  void upload(Field field, std::span<const double> values) override {
    if (is_integer(field)) throw std::logic_error("reals for a field of integers");
    staging_.assign(values.begin(), values.end());
    write(field, staging_.data(), staging_.size());
  }

  void upload(Field field, std::span<const uint32_t> values) override {
    if (!is_integer(field)) throw std::logic_error("integers for a field of reals");
    write(field, values.data(), values.size());
  }

  void download(Field field, std::span<double> values) const override {
    if (is_integer(field)) throw std::logic_error("reals from a field of integers");
    staging_.resize(values.size());
    read(field, staging_.data(), staging_.size());
    std::copy(staging_.begin(), staging_.end(), values.begin());
  }

  void download(Field field, std::span<uint32_t> values) const override {
    if (!is_integer(field)) throw std::logic_error("integers from a field of reals");
    read(field, values.data(), values.size());
  }

  double seconds(Stage stage) const override {
    context_.make_current();
    return timer_.seconds(stage);
  }
  void reset_seconds() override {
    context_.make_current();
    timer_.reset();
  }

  std::string name() const override { return "gpu"; }
  std::string device() const override { return context_.renderer(); }
  Precision precision() const override { return Precision::single_; }
  int threads() const override { return 1; }
  bool guard_is_intact(Field field) const override {
    std::vector<uint32_t> words(guard_);
    context_.make_current();
    read_back_.read(buffer(field), bytes_of(field), words.size() * sizeof(guard_word), words.data());
    return std::ranges::all_of(words, [](uint32_t word) { return word == guard_word; });
  }
  const Buffer& buffer(Field field) const override { return memory_of(field).value().buffer; }

 private:
  /// A field's memory, and the same as texels.
  struct Memory {
    explicit Memory(const Context& context) : buffer(context), texels(context) {}
    Buffer buffer;
    Texture texels;
  };

  std::optional<Memory>& memory_of(Field field) { return memory_[static_cast<uint32_t>(field)]; }
  const std::optional<Memory>& memory_of(Field field) const { return memory_[static_cast<uint32_t>(field)]; }

  uint64_t element_count(Field field) const { return sizes_.of(info(field).length); }
  uint64_t bytes_of(Field field) const { return element_count(field) * element_bytes(info(field).type, 4); }

  template <class F>
  static void for_each_field(FieldSet fields, F&& f) {
    for (uint32_t i = 0; i < field_count; ++i) {
      if (fields.has(static_cast<Field>(i))) f(static_cast<Field>(i));
    }
  }

  bool fits_into_texels() const {
    bool fits = true;
    for_each_field(fields_, [&](Field field) { fits = fits && bytes_of(field) / 4 <= most_texels_; });
    return fits;
  }

  /// Refuses fields that the card has no memory for: drivers may put them into the computer's without a word,
  /// where shaders reach them a hundred times as slowly.
  void require_room(FieldSet fields) const {
    const std::optional<uint64_t> free =
        free_bytes_ > 0 ? std::optional(free_bytes_) : context_.free_memory();
    uint64_t needed = 0;
    for_each_field(fields, [&](Field field) { needed += bytes_of(field); });
    if (!free || needed <= *free) return;
    throw EnvironmentError(fmt::format(
        "the fields need {} of graphics memory, and {} has {} free; use fewer particles, or --backend cpu",
        bytes_text(static_cast<double>(needed)), context_.renderer(),
        bytes_text(static_cast<double>(*free))));
  }

  /// How shaders read from now on.
  void use(Loads loads) {
    if (loads == loads_) return;
    loads_ = loads;
    forget_current();
  }

  void make_field(Field field) {
    Memory& memory = memory_of(field).emplace(context_);
    make_room(context_, memory.buffer, bytes_of(field) + guard_ * sizeof(guard_word), info(field).name);
    write_guard(field);
    if (loads_ == Loads::blocks) return;
    glBindTexture(GL_TEXTURE_BUFFER, memory.texels.name());
    const uint64_t bytes = std::min(std::max<uint64_t>(bytes_of(field), 4), 4 * uint64_t{most_texels_});
    glTexBufferRange(GL_TEXTURE_BUFFER, texel_format(field), memory.buffer.name(), 0,
                     static_cast<GLsizeiptr>(bytes));
  }

  void write_guard(Field field) {
    if (guard_ == 0) return;
    glBufferSubData(GL_COPY_WRITE_BUFFER, static_cast<GLintptr>(bytes_of(field)),
                    static_cast<GLsizeiptr>(guard_ * sizeof(guard_word)),
                    std::vector<uint32_t>(guard_, guard_word).data());
  }

  Groups groups_for(uint64_t count, uint64_t per_group) const {
    return spread((count + per_group - 1) / per_group, most_groups_);
  }

  /// The passes of all stages, and their constants one behind the other.
  void plan_passes() {
    std::vector<std::byte> constants;
    for (uint32_t i = 0; i < stage_count; ++i) {
      passes_[i] = passes_of(static_cast<Stage>(i), sizes_, group_size_);
      first_constants_[i] = constants.size();
      for (const Pass& pass : passes_[i]) {
        const PassConstants values = constants_of(pass, sizes_);
        constants.resize(constants.size() + constants_stride_);
        std::memcpy(constants.data() + constants.size() - constants_stride_, &values, sizeof(values));
      }
    }
    glBindBuffer(GL_UNIFORM_BUFFER, pass_constants_.name());
    glBufferData(GL_UNIFORM_BUFFER, static_cast<GLsizeiptr>(constants.size()), constants.data(),
                 GL_STATIC_DRAW);
    forget_current();
  }

  /// Groups of the passes that end sweeps: those of the largest, as all are bounded by their count.
  GroupNumbers groups_of_test(const std::vector<Stage>& stages) const {
    uint64_t most = 0;
    for (const Stage stage : stages) {
      if (!ends_sweeps(stage)) continue;
      for (const Pass& pass : passes_[static_cast<size_t>(stage)]) most = std::max(most, pass.count);
    }
    const Groups groups = groups_for(most, group_size_);
    return {groups.x, groups.y, 1};
  }

  /// The program of the stage's pass for the needs of now. Needs that make no difference to its text share
  /// it.
  StageProgram& program(Stage stage, size_t pass) {
    const auto s = static_cast<size_t>(stage);
    StageProgram*& current = current_[s][pass];
    if (current == nullptr) {
      const ShaderSource source =
          stage_source(context_.shaders(), stage, needs_, passes_[s][pass], group_size_, loads_);
      auto known = programs_.find(source.text);
      if (known == programs_.end())
        known = programs_.emplace(source.text, StageProgram(context_, stage, source)).first;
      current = &known->second;
    }
    return *current;
  }

  /// Programs are looked for anew: needs, passes or ways of loading have changed.
  void forget_current() {
    for (uint32_t i = 0; i < stage_count; ++i) current_[i].assign(passes_[i].size(), nullptr);
  }

  void bind(const StageProgram& stage_program, size_t constants) const {
    const auto& blocks = stage_program.blocks();
    for (GLuint binding = 0; binding < blocks.size(); ++binding) {
      glBindBufferBase(GL_SHADER_STORAGE_BUFFER, binding, buffer_for(blocks[binding]).name());
    }
    const auto& images = stage_program.images();
    for (GLuint unit = 0; unit < images.size(); ++unit) {
      const std::optional<Memory>& memory = memory_of(images[unit]);
      if (!memory) continue;
      glBindImageTexture(unit, memory->texels.name(), 0, GL_FALSE, 0, GL_READ_ONLY,
                         texel_format(images[unit]));
    }
    glBindBufferBase(GL_UNIFORM_BUFFER, 0, params_.name());
    glBindBufferRange(GL_UNIFORM_BUFFER, 1, pass_constants_.name(), static_cast<GLintptr>(constants),
                      static_cast<GLsizeiptr>(constants_stride_));
  }

  const Buffer& buffer_for(const BoundBlock& block) const {
    switch (block.what) {
      case BoundBlock::What::scratch: return scratch_;
      case BoundBlock::What::sweep_groups: return sweep_groups_;
      case BoundBlock::What::field: break;
    }
    const std::optional<Memory>& memory = memory_of(block.field);
    return memory ? memory->buffer : unused_;  // of a model that the scene does without
  }

  void run(Stage stage, bool unless_solved) {
    timer_.begin();
    const std::vector<Pass>& passes = passes_[static_cast<size_t>(stage)];
    for (size_t k = 0; k < passes.size(); ++k) {
      const Pass& pass = passes[k];
      StageProgram& stage_program = program(stage, k);
      const ComputeProgram& compute = stage_program.program();
      bind(stage_program, first_constants_[static_cast<size_t>(stage)] + k * constants_stride_);
      if (unless_solved)
        compute.dispatch_indirect(sweep_groups_,
                                  static_cast<uint32_t>(sweep_groups_of(stage)) * sizeof(GroupNumbers));
      else
        compute.dispatch(groups_for(pass.count, pass.per_group));
    }
    timer_.end(stage);
  }

  void require_size(Field field, size_t values, size_t bytes) const {
    if (memory_of(field) && bytes == bytes_of(field)) return;
    throw std::logic_error(fmt::format("field {}: {} values for {} elements", info(field).name, values,
                                       memory_of(field) ? element_count(field) : 0));
  }

  template <class T>
  void write(Field field, const T* values, size_t count) {
    require_size(field, count, count * sizeof(T));
    context_.make_current();
    glBindBuffer(GL_COPY_WRITE_BUFFER, buffer(field).name());
    glBufferSubData(GL_COPY_WRITE_BUFFER, 0, static_cast<GLsizeiptr>(count * sizeof(T)), values);
  }

  template <class T>
  void read(Field field, T* values, size_t count) const {
    require_size(field, count, count * sizeof(T));
    context_.make_current();
    read_back_.read(buffer(field), 0, count * sizeof(T), values);
    context_.check(fmt::format("computing on {}", context_.renderer()));
  }

  const Context& context_;
  uint32_t group_size_, most_groups_ = 0, most_texels_ = 0, guard_;
  uint64_t free_bytes_ = 0;
  FieldSet fields_;
  Sizes sizes_;
  Needs needs_;
  mutable StageTimer timer_;
  ReadBack read_back_;
  Buffer params_, pass_constants_, scratch_, sweep_groups_, unused_;
  std::array<std::optional<Memory>, field_count> memory_;
  Loads loads_ = Loads::blocks;
  std::array<std::vector<Pass>, stage_count> passes_;
  size_t constants_stride_ = 0;                        ///< bytes from one pass's constants to the next's
  std::array<size_t, stage_count> first_constants_{};  ///< where those of a stage's first pass stand
  std::map<std::string, StageProgram> programs_;       // by text
  std::array<std::vector<StageProgram*>, stage_count> current_;
  mutable std::vector<float> staging_;
};

}  // namespace

std::unique_ptr<GpuBackend> make_backend(const Context& context, const BackendOptions& options) {
  return std::make_unique<Implementation>(context, options);
}

}  // namespace sluice::gpu
