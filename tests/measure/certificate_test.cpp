// SPDX-License-Identifier: Apache-2.0
// Certificates on machines that are busy with other things, all made up: no clock is asked. A timer that tells the truth is
// certified there, and one that lies in any of the ways in which timers have lied is not.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>

#include "harness/measure/timer_certificate.h"

namespace lamina {
namespace {

using Random = std::mt19937_64;

double uniform(Random& random, double low, double high) { return std::uniform_real_distribution(low, high)(random); }
double waiting_time(Random& random, double mean) { return std::exponential_distribution(1 / mean)(random); }

// For so long the machine gives so much of itself.
struct Spell {
  double ms, rate;
};
struct Machine {
  const char* name;
  std::function<Spell(Random&, size_t)> spell;                        // the n-th
  std::function<double(Random&)> wait = [](Random&) { return 0.0; };  // of a pass with work, before it begins
  int least = 49;                                                     // certificates of 50 that must hold
};
void PrintTo(const Machine& machine, std::ostream* out) { *out << machine.name; }

const Machine machines[] = {
    {"quiet",
     [](Random&, size_t) {
       return Spell{1e9, 1};
     }},
    // Another program takes both cores for some milliseconds now and then.
    {"spikes",
     [](Random& random, size_t n) {
       return n % 2 == 0 ? Spell{waiting_time(random, 40), 1} : Spell{uniform(random, 3, 12), 0};
     }},
    // Three threads on two cores: two thirds of the time only one of ours runs.
    {"one_core_busy",
     [](Random& random, size_t) {
       return Spell{waiting_time(random, 4), random() % 3 == 0 ? 1.0 : 0.5};
     },
     [](Random& random) { return random() % 10 < 3 ? uniform(random, 0, 4) : 0.0; }},
    {"bursts",
     [](Random& random, size_t n) {
       return n % 2 == 0 ? Spell{waiting_time(random, 700), 1} : Spell{waiting_time(random, 500), 0.5};
     }},
    {"stalls",
     [](Random& random, size_t n) {
       return n % 2 == 0 ? Spell{waiting_time(random, 1500), 1} : Spell{200, 0};
     }},
    {"drift",
     [](Random&, size_t n) {
       return Spell{10, 1 + 0.3 * std::sin(static_cast<double>(n) / 50)};
     }},
    // More programs than cores: 45 hold.
    {"two_builds",
     [](Random& random, size_t) {
       constexpr std::array<double, 8> rates = {0, 0, 0.25, 0.25, 0.5, 0.5, 0.5, 1};
       return Spell{waiting_time(random, 6), rates[random() % rates.size()]};
     },
     [](Random& random) { return random() % 2 == 0 ? uniform(random, 0, 12) : 0.0; }, 40},
};

// What a timer makes of the truth.
struct Lie {
  const char* name;
  std::function<void(RunTimes&, Random&)> tell;
};

const Lie lies[] = {
    // Each tile overwrites the begin mark of the one before.
    {"last_tile",
     [](RunTimes& times, Random& random) {
       for (double& ms : times.pass_ms) ms = uniform(random, 3, 3.5);
     }},
    // Timestamps resolve at the end of their scene.
    {"first_pass_gets_all",
     [](RunTimes& times, Random&) {
       const double all = std::accumulate(times.pass_ms.begin(), times.pass_ms.end(), 0.0);
       std::ranges::fill(times.pass_ms, 0.25);
       times.pass_ms.front() = all - 2;
     }},
    {"last_pass_gets_all",
     [](RunTimes& times, Random&) {
       const double all = std::accumulate(times.pass_ms.begin(), times.pass_ms.end(), 0.0);
       std::ranges::fill(times.pass_ms, 0.01);
       times.pass_ms.back() = all;
     }},
    {"a_pass_late", [](RunTimes& times, Random&) { std::ranges::rotate(times.pass_ms, times.pass_ms.end() - 1); }},
    // A dispatch that has run when its timestamps are taken.
    {"deferred",
     [](RunTimes& times, Random&) {
       for (double& ms : times.pass_ms) ms *= 0.0005;
     }},
    // A framebuffer of no size: the time of binding it, on the CPU.
    {"at_bind_time",
     [](RunTimes& times, Random& random) {
       for (double& ms : times.pass_ms) ms = uniform(random, 0.05, 0.2);
     }},
    {"zeros", [](RunTimes& times, Random&) { std::ranges::fill(times.pass_ms, 0.0); }},
    {"all_alike",
     [](RunTimes& times, Random&) {
       const double all = std::accumulate(times.pass_ms.begin(), times.pass_ms.end(), 0.0);
       std::ranges::fill(times.pass_ms, all / static_cast<double>(times.pass_ms.size()));
     }},
    {"counts_double",
     [](RunTimes& times, Random&) {
       for (double& ms : times.pass_ms) ms *= 2;
     }},
    // Half of every pass's time is given to the next one.
    {"half_to_the_next",
     [](RunTimes& times, Random&) {
       const std::vector<double> was = times.pass_ms;
       for (size_t i = 0; i < was.size(); ++i) times.pass_ms[i] = (was[i] + was[(i + was.size() - 1) % was.size()]) / 2;
     }},
};

class Simulated : public TimedWork {
 public:
  Simulated(const Machine& machine, uint64_t seed, const Lie* lie = nullptr)
      : machine_(machine), lie_(lie), random_(seed), spell_(machine.spell(random_, 0)) {}

  void set_duration(double one_ms) override {
    one_ms_ = one_ms;
    one_ms_ *= one_ms / std::min(pass(1), pass(1));
  }

  RunTimes run(std::span<const size_t> kinds) override {
    RunTimes times;
    for (const size_t kind : kinds) {
      times.pass_ms.push_back(pass(kind));
      times.wall_ms += times.pass_ms.back() + 0.1;
    }
    if (lie_) lie_->tell(times, random_);
    clock_ms_ += times.wall_ms;
    return times;
  }
  double clock_s() const { return clock_ms_ / 1000; }

 private:
  double pass(size_t kind) {
    constexpr double fixed_ms = 0.4;
    double ms = kind == 0 ? 0 : machine_.wait(random_);
    double work = (fixed_ms + one_ms_ * timer_multiples[kind]) * uniform(random_, 0.997, 1.003);
    while (work > spell_.ms * spell_.rate) {
      work -= spell_.ms * spell_.rate, ms += spell_.ms;
      spell_ = machine_.spell(random_, ++spells_);
    }
    const double last_ms = work / spell_.rate;
    spell_.ms -= last_ms;
    return ms + last_ms;
  }

  const Machine machine_;
  const Lie* lie_;
  Random random_;
  Spell spell_;
  size_t spells_ = 0;
  double one_ms_ = 1, clock_ms_ = 0;
};

class Certificate : public testing::TestWithParam<Machine> {};
INSTANTIATE_TEST_SUITE_P(On, Certificate, testing::ValuesIn(machines),
                         [](const testing::TestParamInfo<Machine>& machine) { return machine.param.name; });

TEST_P(Certificate, ATimerThatTellsTheTruthIsCertified) {
  int held = 0;
  double longest_s = 0;
  for (uint64_t seed = 1; seed <= 50; ++seed) {
    auto work = std::make_unique<Simulated>(GetParam(), seed);
    const Simulated& machine = *work;
    TimerCertificate certificate(std::move(work));
    while (certificate.is_open() && machine.clock_s() < 90) certificate.run_round();
    held += certificate.row().ok;
    longest_s = std::max(longest_s, machine.clock_s());
  }
  EXPECT_GE(held, GetParam().least) << "the longest took " << longest_s << " s";
  RecordProperty("longest_s", std::to_string(longest_s));
}

TEST_P(Certificate, OneThatLiesNeverIs) {
  for (const Lie& lie : lies)
    for (uint64_t seed = 1; seed <= 4; ++seed) {
      TimerCertificate certificate(std::make_unique<Simulated>(GetParam(), seed, &lie));
      size_t rounds = 0;
      while (certificate.is_open()) certificate.run_round(), ++rounds;
      EXPECT_FALSE(certificate.row().ok) << lie.name << ", seed " << seed << ", after " << rounds << " rounds";
      EXPECT_FALSE(certificate.row().reason.empty());
    }
}

// Rounds may come from an earlier process: what they told is told at once, and they are not measured again.
TEST(CertificateRounds, GoOnFromEarlierRounds) {
  TimerCertificate first(std::make_unique<Simulated>(machines[0], 1));
  for (int round = 0; round < 5; ++round) first.run_round();
  EXPECT_FALSE(first.row().ok) << "five rounds tell nothing";
  EXPECT_TRUE(first.is_open());
  TimerCertificate second(std::make_unique<Simulated>(machines[0], 2), first.rounds());
  second.run_round();
  EXPECT_TRUE(second.row().ok) << second.row().reason;
  EXPECT_FALSE(second.is_open());
  TimerCertificate third(std::make_unique<Simulated>(machines[0], 3), second.rounds());
  EXPECT_TRUE(third.row().ok);
  third.run_round();
  EXPECT_EQ(third.rounds().times_ms.size(), 6u) << "what is known is not measured";
}

}  // namespace
}  // namespace lamina
