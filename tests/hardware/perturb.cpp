// Copies the stages' shaders to the folder named on the command line, with every divisor and every root off
// by -1, 0 or 1 unit in the last place, as the value's own bits choose. So cards compute, which take
// reciprocals that are not rounded correctly; processors do not.
#include <cctype>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>
#include <string>

namespace {

constexpr const char* off_by_an_ulp = R"(
float off_by_an_ulp(float a) {
  uint bits = floatBitsToUint(a), hash = bits * 2654435761u;
  hash ^= hash >> 15u;
  return a == 0.0 || isnan(a) || isinf(a) ? a : uintBitsToFloat(bits + (hash >> 8u) % 3u - 1u);
}
vec2 off_by_an_ulp(vec2 a) { return vec2(off_by_an_ulp(a.x), off_by_an_ulp(a.y)); }
uint off_by_an_ulp(uint a) { return a; }
)";

/// Place behind the parenthesis that closes the one at `at`.
size_t behind_parentheses(const std::string& text, size_t at) {
  int open = 0;
  for (; at < text.size(); ++at) {
    open += text[at] == '(' ? 1 : text[at] == ')' ? -1 : 0;
    if (open == 0) return at + 1;
  }
  return at;
}

/// Place behind the operand that begins at `at`: a name or a number, with what is called or selected, or
/// parentheses.
size_t behind_operand(const std::string& text, size_t at) {
  const auto is_word = [](char c) {
    return std::isalnum(static_cast<unsigned char>(c)) || c == '_' || c == '.';
  };
  while (at < text.size() && is_word(text[at])) ++at;
  while (at < text.size() && text[at] == '(') {
    at = behind_parentheses(text, at);
    while (at < text.size() && is_word(text[at])) ++at;
  }
  return at;
}

void wrap(std::string& text, size_t from, size_t to) {
  text.insert(to, ")");
  text.insert(from, "off_by_an_ulp(");
}

std::string perturbed(std::string text) {
  for (size_t at = 0; at < text.size(); ++at) {
    if (text.compare(at, 2, "//") == 0) at = text.find('\n', at);
    if (at == std::string::npos) break;
    if (text.compare(at, 5, "sqrt(") == 0 &&
        (at == 0 || !std::isalnum(static_cast<unsigned char>(text[at - 1])))) {
      wrap(text, at, behind_parentheses(text, at + 4));
      at += std::string_view("off_by_an_ulp(sqrt").size();
    } else if (text.compare(at, 3, "/= ") == 0) {
      wrap(text, at + 3, text.find(';', at));
    } else if (text.compare(at, 2, "/ ") == 0) {
      wrap(text, at + 2, behind_operand(text, at + 2));
    }
  }
  return text;
}

}  // namespace

int main(int count, char** words) {
  namespace fs = std::filesystem;
  if (count != 3) return 2;
  const fs::path from = words[1], to = words[2];
  fs::create_directories(to / "lib");
  int changed = 0;
  for (const fs::path& folder : {fs::path(), fs::path("lib")}) {
    for (const auto& entry : fs::directory_iterator(from / folder)) {
      if (!entry.is_regular_file()) continue;
      std::ifstream file(entry.path());
      const std::string text{std::istreambuf_iterator<char>(file), {}};
      const bool stage = folder.empty();
      const std::string other = entry.path().filename() == "probe_storage.comp" ? text : perturbed(text);
      changed += other == text ? 0 : 1;
      std::ofstream(to / folder / entry.path().filename()) << (stage ? off_by_an_ulp : "") << other;
    }
  }
  if (changed > 5) return 0;
  std::cerr << "perturb: no divisions were found\n";
  return 1;
}
