// The linear system of IISPH as an operator on q = p/rho^2: symmetric and positive semi-definite with every
// boundary but the thesis's mirror wall, and with the diagonal that is used.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "core/model/larger.hpp"
#include "core/scene/random.hpp"
#include "tests/support/simulation.hpp"

namespace sluice::test {
namespace {

using Values = std::vector<double>;

struct System {
  const char* name;
  std::vector<std::string> settings;
  bool symmetric;
};

void PrintTo(const System& system, std::ostream* out) { *out << system.name; }

double dot(const Values& a, const Values& b) {
  double sum = 0;
  for (size_t i = 0; i < a.size(); ++i) sum += a[i] * b[i];
  return sum;
}

class PressureSystem : public testing::TestWithParam<System> {
 protected:
  PressureSystem() { simulation_.run(150); }  // the dam has met the right wall: no lattice, strays, corners

  size_t n() const { return simulation_.samples.fluid.size(); }

  /// Minus the operator, applied to q.
  Values K(const Values& q) const {
    simulation_.backend->upload(Field::q, q);
    simulation_.backend->run(Stage::pressure_acceleration);
    simulation_.backend->run(Stage::pressure_operator);
    Values Kq(n());
    simulation_.backend->download(Field::Ap, Kq);
    for (double& value : Kq) value = -value;
    return Kq;
  }

  Values random(uint64_t seed) const {
    Random random(seed);
    Values values(n());
    for (double& value : values) value = 2 * random.uniform() - 1;
    return values;
  }

  Values diagonal() const {
    Values A_ii(n());
    simulation_.backend->download(Field::A_ii, A_ii);
    return A_ii;
  }

 private:
  static Scene scene() {
    std::vector<std::string> settings = GetParam().settings;
    settings.insert(settings.end(), {"fluid.jitter=0.1", "viscosity.coefficient=50"});
    return shipped("breaking_dam", settings);
  }
  mutable Simulation simulation_{scene()};
};

constexpr double rounding = 1e-12;

TEST_P(PressureSystem, IsSymmetricUnlessTheWallIsTheThesiss) {
  double largest = 0;
  for (uint64_t seed = 1; seed <= 20; ++seed) {
    const Values a = random(seed), b = random(seed + 100);
    const Values Ka = K(a), Kb = K(b);
    ASSERT_GT(dot(a, a), 0);
    largest = larger(largest, std::abs(dot(b, Ka) - dot(a, Kb)) / std::sqrt(dot(Ka, Ka) * dot(b, b)));
  }
  if (GetParam().symmetric) {
    EXPECT_LT(largest, rounding);
  } else {
    EXPECT_GT(largest, 1e-4);
  }
}

class SymmetricSystem : public PressureSystem {};

TEST_P(SymmetricSystem, IsPositiveSemiDefinite) {
  for (uint64_t seed = 1; seed <= 20; ++seed) {
    // Rough, and then smoother and smoother: the operator takes out what is rough.
    Values q = random(seed);
    const double largest = std::sqrt(dot(K(q), K(q)) / dot(q, q));
    for (int smoothed = 0; smoothed < 10; ++smoothed) {
      const Values Kq = K(q);
      EXPECT_GE(dot(q, Kq), -rounding * largest * dot(q, q)) << seed << ", " << smoothed;
      for (size_t i = 0; i < q.size(); ++i) q[i] -= 0.5 / largest * Kq[i];
    }
  }
}

TEST_P(PressureSystem, HasTheDiagonalThatIsUsed) {
  const Values A_ii = diagonal();
  double difference = 0, largest = 0;
  for (size_t i = 0; i < n(); i += 7) {
    Values unit(n());
    unit[i] = 1;
    difference = larger(difference, std::abs(A_ii[i] + K(unit)[i]));
    largest = std::max(largest, std::abs(A_ii[i]));
  }
  if (GetParam().symmetric) {
    EXPECT_LT(difference, rounding * largest);
  } else {
    EXPECT_GT(difference, 1e-3 * largest)
        << "mirror samples are in the thesis's diagonal, not in its operator";
  }
}

const System symmetric{"symmetric", {"pressure.iisph.wall=symmetric"}, true};
const System akinci{"akinci", {"boundary.model=akinci"}, true};
const System no_boundary{
    "none",
    {"boundary.container=[]", "fluid.gravity=[0,0]", "fluid.central_force=0.01", "fluid.centre=[112,144]"},
    true};
const System thesis{"thesis", {"pressure.iisph.wall=thesis"}, false};

const auto name_of_test = [](const auto& test) { return std::string(test.param.name); };
INSTANTIATE_TEST_SUITE_P(Boundaries, PressureSystem, testing::Values(symmetric, akinci, no_boundary, thesis),
                         name_of_test);
INSTANTIATE_TEST_SUITE_P(Boundaries, SymmetricSystem, testing::Values(symmetric, akinci, no_boundary),
                         name_of_test);

// Samples with pseudo-masses have no other wall term.
TEST(AkinciBoundary, IsTheSameWithEitherWall) {
  const auto run = [](const std::string& wall) {
    Simulation simulation(shipped("iisph_box", {"pressure.iisph.wall=" + wall, "fluid.relax=2"}));
    simulation.run(200);
    return simulation.simulator->snapshot();
  };
  EXPECT_EQ(run("thesis").x, run("symmetric").x);
}

}  // namespace
}  // namespace sluice::test
