// Pictures survive the way through a PNG file, and a failure on the writer's thread reaches the caller.
#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

#include "draw/image.hpp"
#include "sluice/error.hpp"

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wconversion"
#pragma GCC diagnostic ignored "-Wsign-conversion"
#pragma GCC diagnostic ignored "-Wshadow"
#pragma GCC diagnostic ignored "-Wmissing-field-initializers"
#pragma GCC diagnostic ignored "-Wunused-function"
#pragma GCC diagnostic ignored "-Wunused-but-set-variable"
#define STB_IMAGE_IMPLEMENTATION
#define STB_IMAGE_STATIC
#define STBI_ONLY_PNG
#define STBI_NO_STDIO
#include <stb_image.h>
#pragma GCC diagnostic pop

namespace {

namespace fs = std::filesystem;
using sluice::draw::Image;

Image pattern(uint32_t width, uint32_t height, uint32_t seed) {
  Image image{width, height, {}};
  uint32_t state = seed;
  for (uint32_t k = 0; k < width * height * 3; ++k) {
    state = state * 1664525u + 1013904223u;
    image.rgb.push_back(k % 7 < 4 ? 255 : static_cast<uint8_t>(state >> 24));
  }
  return image;
}

Image decode(const std::string& png) {
  int width = 0, height = 0, channels = 0;
  stbi_uc* pixels = stbi_load_from_memory(reinterpret_cast<const stbi_uc*>(png.data()),
                                          static_cast<int>(png.size()), &width, &height, &channels, 0);
  if (pixels == nullptr || channels != 3) return {};
  Image image{static_cast<uint32_t>(width), static_cast<uint32_t>(height), {}};
  image.rgb.assign(pixels, pixels + size_t{image.width} * image.height * 3);
  stbi_image_free(pixels);
  return image;
}

std::string read(const fs::path& path) {
  std::ostringstream text;
  text << std::ifstream(path, std::ios::binary).rdbuf();
  return text.str();
}

class PngWriterTest : public testing::Test {
 protected:
  void SetUp() override {
    std::string name = (fs::temp_directory_path() / "sluice-test-XXXXXX").string();
    ASSERT_NE(mkdtemp(name.data()), nullptr);
    folder = name;
  }
  void TearDown() override { fs::remove_all(folder); }
  fs::path folder;
};

TEST(Png, RoundTrip) {
  for (const auto& [width, height] : {std::pair{1u, 1u}, {17u, 33u}, {401u, 7u}, {64u, 64u}}) {
    const Image image = pattern(width, height, width);
    const Image back = decode(sluice::draw::encode_png(image));
    EXPECT_EQ(back.width, width);
    EXPECT_EQ(back.height, height);
    EXPECT_TRUE(back.rgb == image.rgb) << width << " x " << height;
  }
}

TEST(Png, SameBytesEachTime) {
  EXPECT_EQ(sluice::draw::encode_png(pattern(50, 40, 1)), sluice::draw::encode_png(pattern(50, 40, 1)));
}

TEST(Png, RefusesWhatIsNoPicture) {
  EXPECT_THROW(sluice::draw::encode_png({}), sluice::InputError);
  EXPECT_THROW(sluice::draw::encode_png({2, 2, std::vector<uint8_t>(11)}), sluice::InputError);
}

TEST_F(PngWriterTest, WritesMorePicturesThanItsQueueHolds) {
  sluice::draw::PngWriter writer(2);
  for (uint32_t k = 0; k < 12; ++k) writer.write(folder / std::to_string(k), pattern(30 + k, 20, k));
  writer.finish();
  for (uint32_t k = 0; k < 12; ++k) {
    EXPECT_TRUE(decode(read(folder / std::to_string(k))).rgb == pattern(30 + k, 20, k).rgb) << k;
  }
  EXPECT_THROW(writer.write(folder / "late", pattern(2, 2, 1)), sluice::Error);
}

TEST_F(PngWriterTest, TheDestructorWritesWhatWaits) {
  {
    sluice::draw::PngWriter writer;
    for (uint32_t k = 0; k < 3; ++k) writer.write(folder / std::to_string(k), pattern(30, 20, k));
  }
  for (uint32_t k = 0; k < 3; ++k) EXPECT_EQ(decode(read(folder / std::to_string(k))).width, 30u);
}

TEST_F(PngWriterTest, FlushWaitsForWhatWasGivenAndGoesOn) {
  sluice::draw::PngWriter writer;
  for (uint32_t k = 0; k < 6; ++k) {
    writer.write(folder / std::to_string(k), pattern(300, 200, k));
    if (k % 2 == 0) continue;
    writer.flush();
    EXPECT_EQ(decode(read(folder / std::to_string(k))).width, 300u);
  }
  writer.write(folder / "missing" / "a.png", pattern(2, 2, 1));
  EXPECT_THROW(writer.flush(), sluice::EnvironmentError);
}

TEST_F(PngWriterTest, AFailureReachesFinish) {
  sluice::draw::PngWriter writer;
  writer.write(folder / "missing" / "a.png", pattern(2, 2, 1));
  EXPECT_THROW(writer.finish(), sluice::EnvironmentError);
  EXPECT_THROW(writer.finish(), sluice::EnvironmentError);
}

TEST_F(PngWriterTest, AFailureReachesALaterWrite) {
  sluice::draw::PngWriter writer(1);
  const auto write_many = [&] {
    for (int k = 0; k < 1000; ++k) writer.write("/dev/full", pattern(64, 64, 1));
  };
  EXPECT_THROW(write_many(), sluice::EnvironmentError);
}

TEST_F(PngWriterTest, AFailureInTheDestructorDoesNotEscape) {
  EXPECT_NO_THROW({
    sluice::draw::PngWriter writer;
    writer.write("/dev/full", pattern(64, 64, 1));
  });
}

}  // namespace
