// Every shader of every stage goes through the compiler of AMD's graphics cards, without a card: Mesa's
// Vulkan driver compiles for the family that RADV_FORCE_FAMILY names. Each family is a process of its own, as
// the driver asks once.
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <vulkan/vulkan.h>

#include <cstdlib>
#include <filesystem>
#include <map>
#include <stdexcept>

#include "tests/support/all_shaders.hpp"
#include "tests/support/spirv.hpp"

// Vulkan's structures are filled by name; what is not named is zero, as it should be.
#pragma GCC diagnostic ignored "-Wmissing-field-initializers"

namespace sluice::test {
namespace {

void require(VkResult result, const char* doing) {
  if (result != VK_SUCCESS) throw std::runtime_error(fmt::format("{}: Vulkan result {}", doing, int(result)));
}

/// Types of the descriptors that a shader declares, by binding.
std::map<uint32_t, VkDescriptorType> descriptors_of(const std::vector<SpirvInstruction>& module) {
  constexpr uint32_t variable = 59, decorate = 71, binding = 33, uniform_constant = 0, storage_buffer = 12,
                     block = 2, buffer_block = 3, type_pointer = 32;
  std::map<uint32_t, uint32_t> bindings, pointees;
  std::map<uint32_t, bool> writable_blocks;
  for (const auto& [code, operands] : module) {
    if (code == decorate && operands[1] == binding) bindings[operands[0]] = operands[2];
    if (code == decorate && (operands[1] == block || operands[1] == buffer_block))
      writable_blocks[operands[0]] = operands[1] == buffer_block;
    if (code == type_pointer) pointees[operands[0]] = operands[2];
  }
  std::map<uint32_t, VkDescriptorType> types;
  for (const auto& [code, operands] : module) {
    if (code != variable || !bindings.contains(operands[1])) continue;
    const bool storage = operands[2] == storage_buffer || writable_blocks[pointees[operands[0]]];
    types[bindings[operands[1]]] = operands[2] == uniform_constant ? VK_DESCRIPTOR_TYPE_STORAGE_TEXEL_BUFFER
                                   : storage                       ? VK_DESCRIPTOR_TYPE_STORAGE_BUFFER
                                                                   : VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER;
  }
  return types;
}

/// A device of no card that compiles for the family of the environment.
class Compiler {
 public:
  Compiler() {
    const VkApplicationInfo application{.sType = VK_STRUCTURE_TYPE_APPLICATION_INFO,
                                        .apiVersion = VK_API_VERSION_1_1};
    const VkInstanceCreateInfo instance{.sType = VK_STRUCTURE_TYPE_INSTANCE_CREATE_INFO,
                                        .pApplicationInfo = &application};
    require(vkCreateInstance(&instance, nullptr, &instance_), "an instance");
    uint32_t count = 1;
    vkEnumeratePhysicalDevices(instance_, &count, &physical_);
    if (count != 1 || physical_ == nullptr) throw std::runtime_error("no device");
    VkPhysicalDeviceProperties properties;
    vkGetPhysicalDeviceProperties(physical_, &properties);
    name = static_cast<const char*>(properties.deviceName);
    const float priority = 1;
    const VkDeviceQueueCreateInfo queue{
        .sType = VK_STRUCTURE_TYPE_DEVICE_QUEUE_CREATE_INFO, .queueCount = 1, .pQueuePriorities = &priority};
    const VkDeviceCreateInfo device{.sType = VK_STRUCTURE_TYPE_DEVICE_CREATE_INFO,
                                    .queueCreateInfoCount = 1,
                                    .pQueueCreateInfos = &queue};
    require(vkCreateDevice(physical_, &device, nullptr, &device_), "a device");
  }
  ~Compiler() {
    if (device_ != nullptr) vkDestroyDevice(device_, nullptr);
    if (instance_ != nullptr) vkDestroyInstance(instance_, nullptr);
  }
  Compiler(const Compiler&) = delete;
  Compiler& operator=(const Compiler&) = delete;

  void compile(const std::vector<uint32_t>& words) const {
    std::vector<VkDescriptorSetLayoutBinding> bindings;
    for (const auto& [binding, type] : descriptors_of(instructions_of(words)))
      bindings.push_back({binding, type, 1, VK_SHADER_STAGE_COMPUTE_BIT, nullptr});
    const VkDescriptorSetLayoutCreateInfo set{.sType = VK_STRUCTURE_TYPE_DESCRIPTOR_SET_LAYOUT_CREATE_INFO,
                                              .bindingCount = static_cast<uint32_t>(bindings.size()),
                                              .pBindings = bindings.data()};
    VkDescriptorSetLayout set_layout = nullptr;
    require(vkCreateDescriptorSetLayout(device_, &set, nullptr, &set_layout), "a set of descriptors");
    const VkPipelineLayoutCreateInfo layout_info{.sType = VK_STRUCTURE_TYPE_PIPELINE_LAYOUT_CREATE_INFO,
                                                 .setLayoutCount = 1,
                                                 .pSetLayouts = &set_layout};
    VkPipelineLayout layout = nullptr;
    require(vkCreatePipelineLayout(device_, &layout_info, nullptr, &layout), "a layout");
    const VkShaderModuleCreateInfo module_info{.sType = VK_STRUCTURE_TYPE_SHADER_MODULE_CREATE_INFO,
                                               .codeSize = 4 * words.size(),
                                               .pCode = words.data()};
    VkShaderModule module = nullptr;
    require(vkCreateShaderModule(device_, &module_info, nullptr, &module), "a module");
    const VkComputePipelineCreateInfo info{
        .sType = VK_STRUCTURE_TYPE_COMPUTE_PIPELINE_CREATE_INFO,
        .stage = {.sType = VK_STRUCTURE_TYPE_PIPELINE_SHADER_STAGE_CREATE_INFO,
                  .stage = VK_SHADER_STAGE_COMPUTE_BIT,
                  .module = module,
                  .pName = "main"},
        .layout = layout};
    VkPipeline pipeline = nullptr;
    require(vkCreateComputePipelines(device_, nullptr, 1, &info, nullptr, &pipeline), "a pipeline");
    vkDestroyPipeline(device_, pipeline, nullptr);
    vkDestroyShaderModule(device_, module, nullptr);
    vkDestroyPipelineLayout(device_, layout, nullptr);
    vkDestroyDescriptorSetLayout(device_, set_layout, nullptr);
  }

  std::string name;

 private:
  VkInstance instance_ = nullptr;
  VkPhysicalDevice physical_ = nullptr;
  VkDevice device_ = nullptr;
};

// The driver's library writes what it finds amiss to standard error, and ends the process for the worst.
TEST(HardwareCompiler, TakesEveryShaderOfEveryStage) {
  const char* family = std::getenv("RADV_FORCE_FAMILY");
  ASSERT_NE(family, nullptr) << "set RADV_FORCE_FAMILY; its ctest runs do";
  const TemporaryFolder folder;
  const int count = write_all_stages(folder);
  ASSERT_EQ(compile_to_spirv(folder), "");
  const Compiler compiler;
  EXPECT_NE(compiler.name.find("RADV"), std::string::npos) << compiler.name;
  int compiled = 0;
  for (const auto& entry : std::filesystem::directory_iterator(folder.path)) {
    if (entry.path().extension() != ".spv") continue;
    SCOPED_TRACE(entry.path().stem().string());
    EXPECT_NO_THROW(compiler.compile(read_spirv(entry.path())));
    ++compiled;
  }
  EXPECT_EQ(compiled, count);
}

}  // namespace
}  // namespace sluice::test
