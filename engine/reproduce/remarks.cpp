#include "engine/reproduce/remarks.h"

#include <spdlog/fmt/fmt.h>

#include <algorithm>

#include "engine/compare/conclusion.h"
#include "engine/reproduce/paper.h"
#include "engine/reproduce/tables.h"

namespace spoke::reproduce {
namespace {

constexpr const char* kWithoutOpenMp =
    "This build is without OpenMP, so the paper's two schemes could not be measured.";
constexpr const char* kNothing = "Too little could be measured to say anything.";

/// How much faster than the dense serial step, in the same rounds.
std::optional<double> speedup(const Reproduction& all, Work work, int number,
                              graph::Threads threads) {
  return all.timings.ratio(work, serial(Formulation::subsystem), scheme(number, threads));
}

/// Why more threads than there are processors gain nothing.
std::string processors_text(const Reproduction& all, int threads) {
  const int cores = all.machine.cores;
  if (threads <= cores)
    return fmt::format("This machine offers {} processors, enough for all threads.", cores);
  return fmt::format(
      "Here {} processors are available to {} threads: at best {} of 3 blades run at once, so a "
      "step cannot fall below {:.2f} of serial's as long as a blade stays on one thread.",
      cores, threads, cores, std::max(1.0 / 3.0, (cores == 1 ? 3.0 : 2.0) / 3.0));
}

/// What the runtime does with inner teams; only of the runtime that this is known of.
std::string runtime_text(const Reproduction& all) {
  if (all.machine.compiler.find("lang") != std::string::npos)
    return "LLVM's OpenMP keeps inner teams between regions, so scheme 2 pays for waking them, not "
           "for making them.";
  return "GCC's OpenMP does not keep the threads of inner teams: scheme 2 makes and ends them at "
         "every loop over bodies, thousands in a second, while scheme 1 makes them once. With more "
         "threads than processors, one that spins while it waits takes the processor from one "
         "that has work.";
}

}  // namespace

std::string remark_on_counts() {
  const paper::InverseSizes sizes = paper::inverse_sizes();
  const auto total = [](Formulation formulation) {
    return static_cast<double>(count(formulation).total());
  };
  const double structured = total(Formulation::structured);
  return fmt::format(
      "The paper's formulas give its printed numbers, every line and the total. Its largest item, "
      "{:.1f} % for the inverse of M_sub, multiplies sizes where it should add them: a blade has "
      "M (3 + 3E) = 60 unknowns, not (3M)(3(E+1)) = 180. By the same rule n^3/3 the item is {} for "
      "three matrices of 60, and {} for the twelve blocks of 15 that (P 11) consists of, {:.0f} "
      "times less than printed. Counted here are multiplications, additions and, one each, "
      "divisions, roots and trigonometric functions. By this count the subsystem formulation "
      "needs {:.0f} times fewer operations than the augmented one, and the structured formulation "
      "{:.1f} times fewer again; the inverse is {:.0f} % of the subsystem formulation's work.",
      100.0 * static_cast<double>(sizes.printed) / static_cast<double>(paper::kTable2Total),
      sizes.blade, sizes.blocks,
      static_cast<double>(sizes.printed) / static_cast<double>(sizes.blocks),
      total(Formulation::augmented) / total(Formulation::subsystem),
      total(Formulation::subsystem) / structured,
      100.0 * static_cast<double>(count(Formulation::subsystem, Stage::inverse).total()) /
          total(Formulation::subsystem));
}

std::string remark_on_drive(const Reproduction& all) {
  if (all.drive.empty()) return kNothing;
  const DriveMotion& end = all.drive.back().motion;
  double most = 0.0;
  for (const DrivePoint& point : all.drive) most = std::max(most, point.motion.acceleration);
  return fmt::format(
      "(P 12) with the factor Ts/(2 pi): the hub starts and ends its ramp without a jump, reaches "
      "{:.3g} rad/s at 15 s and has turned by {:.4g} rad at {:.3g} s; the acceleration is at most "
      "{:.3g} rad/s^2. As printed, with (Ts/2) pi, the hub would start backwards. The paper does "
      "not print the final speed; 4 rad/s is that of Wu and Haug (1988).",
      end.speed, end.angle, all.drive.back().t, most);
}

std::string remark_on_deflection(const Reproduction& all) {
  const auto error = [](const Deflection& deflection) {
    return 100.0 * std::abs(deflection.lag / exact::kLag - 1.0);
  };
  return fmt::format(
      "Agreeing with the paper, the tip lags more and more while the hub speeds up, comes back, "
      "and vibrates with a small amplitude at constant speed. Differing: the paper's model has no "
      "stiffening within a body, so the peak of {:.4f} m is {:.2g} % beyond the exact {:.4f} m, "
      "later by {:.2f} s, and the vibration that remains ({:.2g} m) is {:.1f} times too small. "
      "With "
      "stiffening the same mesh is {:.2g} % off. A history of the exact solution is not part of "
      "this program; the dashed curve is its finest stiffened model, the marked points are the "
      "independent solution.",
      all.paper.lag, error(all.paper), exact::kLag, all.paper.lag_time - exact::kLagTime,
      all.paper.residual, exact::kResidual / all.paper.residual, error(all.stiffened));
}

std::string remark_on_subsystem_threads(const Reproduction& all) {
  if (!has_schemes()) return kWithoutOpenMp;
  const auto one_2 = speedup(all, Work::steps, 1, 2), one_3 = speedup(all, Work::steps, 1, 3);
  const auto two_2 = speedup(all, Work::steps, 2, 2), two_3 = speedup(all, Work::steps, 2, 3);
  if (!one_2 || !one_3 || !two_2 || !two_3) return kNothing;
  const double better = std::max(*one_2 / *two_2, *two_2 / *one_2);
  const char* winner =
      better < 1.1      ? "the schemes are about equal, as in the paper"
      : *one_2 > *two_2 ? "scheme 1 is clearly the faster, where the paper sees little difference"
                        : "scheme 2 is clearly the faster, unlike in the paper";
  return fmt::format(
      "In the paper the time falls as one over the threads, by 2.77 on three. Here scheme 1 gains "
      "{:.2f} on two threads and {:.2f} on three, scheme 2 {:.2f} and {:.2f}; on two threads {}. "
      "{}",
      *one_2, *one_3, *two_2, *two_3, winner, processors_text(all, 3));
}

std::string remark_on_layers(const Reproduction& all) {
  if (!has_schemes()) return kWithoutOpenMp;
  const auto slower = [&](int number, int inner) {
    return all.timings.ratio(Work::steps, scheme(number, {3, inner}), scheme(number, {3, 1}));
  };
  const auto two = slower(1, 2), four = slower(1, 4), two_2 = slower(2, 2), four_2 = slower(2, 4);
  if (!two || !four || !two_2 || !four_2) return kNothing;
  const char* verdict = *two < 0.97 ? "as in the paper, two inner threads gain over one"
                                    : "unlike in the paper, inner threads gain nothing over 3x1";
  const char* schemes = *four_2 > *four
                            ? "As in the paper, scheme 2 suffers more from more threads."
                            : "Unlike in the paper, scheme 2 does not suffer more.";
  return fmt::format(
      "The paper finds 3x2 fastest, and scheme 2 on 3x4 some 1.8 times slower than on 3x1. Here "
      "{}: "
      "scheme 1 takes {:.2f} times its 3x1 on 3x2 and {:.2f} times on 3x4, scheme 2 {:.2f} and "
      "{:.2f} times. {} {} {}",
      verdict, *two, *four, *two_2, *four_2, schemes, runtime_text(all), processors_text(all, 12));
}

std::string remark_on_inverse(const Reproduction& all) {
  const auto whole = all.timings.find(Work::steps, serial(Formulation::subsystem));
  const auto part = all.timings.find(Work::inverse, serial(Formulation::subsystem));
  if (!whole || !part) return kNothing;
  std::string text = fmt::format(
      "Measured as runs of a graph that has the step's inverse nodes and no others, as often as in "
      "a step; with threads the forks and barriers of these loops are in it. A node inverts one "
      "block of (P 11): assembly, factorisation, right-hand sides. Serially these nodes are {:.0f} "
      "% of a step (Table 2 says 74.9 % for the inverse alone). ",
      100.0 * part->median / whole->median);
  if (!has_schemes()) return text + kWithoutOpenMp;
  const auto four = all.timings.ratio(Work::inverse, scheme(1, {3, 4}), scheme(1, {3, 1}));
  const auto four_2 = all.timings.ratio(Work::inverse, scheme(2, {3, 4}), scheme(2, {3, 1}));
  if (!four || !four_2) return text;
  return text + fmt::format(
                    "In the paper this part falls with every inner thread. Here 3x4 takes {:.2f} "
                    "times what 3x1 takes with scheme 1, {:.2f} times with scheme 2: {}",
                    *four, *four_2,
                    std::min(*four, *four_2) < 0.97
                        ? "it falls for at least one of them, as in the paper."
                        : "the nodes take microseconds each, less than waking a thread, and there "
                          "are not twelve processors.");
}

std::string remark_on_methods(const Reproduction& all) {
  const auto ratio = [&](const compare::Configuration& above, const compare::Configuration& below) {
    return all.timings.ratio(Work::steps, above, below).value_or(0.0);
  };
  const auto dense = serial(Formulation::subsystem), own = serial(Formulation::structured);
  std::string text = fmt::format(
      "The algorithm's gain is confirmed: conventional to subsystem is 3.6 in the paper, {:.1f} "
      "here. ",
      ratio(serial(Formulation::augmented), dense));
  if (const auto layered = best_layered(all))
    text += fmt::format(
        "The gain of threads is not: subsystem to parallel is 2.77 there and {:.2f} here on {} "
        "processors, parallel to layered 3.6 there and {:.2f} here. Two inner threads cannot by "
        "themselves make a step 3.6 times faster, so the paper's last column, a time per thread in "
        "its text, may not be the time of a step. ",
        ratio(dense, scheme(1, 3)), all.machine.cores, ratio(scheme(1, 3), scheme(1, *layered)));
  else
    text += std::string(kWithoutOpenMp) + ' ';
  text += fmt::format(
      "The structured formulation makes a step {:.1f} times faster than the subsystem one, both on "
      "one thread; the executor auto takes {:.2f} times that time (steps of microseconds are best "
      "left to one thread). ",
      ratio(dense, own), ratio(automatic(Formulation::structured), own));
  for (const MethodTime& time : method_times(all))
    if (time.name == "Spoke, implicit" && time.run)
      text += fmt::format(
          "An implicit step of {:.3g} s simulates the 20 s in {}; its largest lag differs by "
          "{:.2g} "
          "% from the same model's converged one.",
          all.implicit.step, compare::duration_text(*time.run), 100.0 * all.implicit.error);
  return text;
}

}  // namespace spoke::reproduce
