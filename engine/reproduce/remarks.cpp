// The paragraphs, a function for each table and figure.

#include "engine/reproduce/remarks.h"

#include <spdlog/fmt/fmt.h>

#include <algorithm>

#include "engine/report/markup.h"
#include "engine/reproduce/paper.h"
#include "engine/reproduce/tables.h"
#include "graph/machine/duration_text.h"
#include "models/count_text.h"

namespace spoke::reproduce {
namespace {

constexpr const char* kWithoutOpenMp =
    "This build is without OpenMP, so the paper's two schemes could not be measured.";
constexpr const char* kUntold = "not to be told, for the times vary too much";
constexpr double kGain = 0.97;  // of the time without, below which threads gain something
constexpr const char* kNothing = "Too little could be measured to say anything.";

/// As side_of(), but on a busy machine nothing is told of threads, which then wait for processors.
Side side_of_threads(const Reproduction& all, const Ratio& ratio, double limit) {
  return is_disturbed(all) ? Side::untold : side_of(ratio, limit);
}

/// What to say of each side.
const char* choose(Side side, const char* below, const char* above, const char* untold) {
  return side == Side::untold ? untold : side == Side::below ? below : above;
}

std::string text_of(const Ratio& ratio) { return report::ratio_text(ratio.median); }

/// How much faster than the dense serial step, in the same rounds.
std::optional<Ratio> speedup(const Reproduction& all, Work work, int number,
                             graph::Threads threads) {
  return all.timings.ratio(work, serial(Formulation::subsystem), scheme(number, threads));
}

/// What threads can gain at best on the processors there are, of three blades.
std::string processors_text(const Reproduction& all, int threads) {
  const int cores = all.machine.cores;
  if (threads <= cores)
    return fmt::format("This machine offers {}, enough for all threads.",
                       counted(cores, "processor"));
  if (threads > 3)
    return fmt::format(
        "{} threads share {} here, of scheme 1 only as many work: no step can take less than "
        "{:.2f} "
        "of serial's time.",
        threads, counted(cores, "processor"), 1.0 / cores);
  return fmt::format(
      "Three blades on {}: while each stays on one thread, a step takes at least {:.2f} of "
      "serial's "
      "time, whatever the number of threads.",
      counted(cores, "processor"), (cores == 1 ? 3.0 : 2.0) / 3.0);
}

std::string disturbance_text(const Reproduction& all) {
  return is_disturbed(all) ? " The machine was busy meanwhile: barriers then wait for threads that "
                             "have no processor, and there is no verdict on threads."
                           : "";
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

std::string remark_on_threads_of_methods(const Reproduction& all, graph::Threads layered) {
  const auto threads = all.timings.ratio(Work::steps, serial(Formulation::subsystem), scheme(1, 3));
  const auto layers = all.timings.ratio(Work::steps, scheme(1, 3), scheme(1, layered));
  if (!threads || !layers) return "";
  return fmt::format(
      "The gain of threads is {}: subsystem to parallel is 2.77 there and {} here on {}, parallel "
      "to "
      "layered 3.6 there and {} here. Two inner threads cannot by "
      "themselves make a step 3.6 times faster; if the paper's last column is a time per thread, "
      "as in its Fig. 10, it is not the time of a step.{} ",
      choose(side_of_threads(all, *threads, 2.2), "not confirmed", "confirmed", kUntold),
      text_of(*threads), counted(all.machine.cores, "processor"), text_of(*layers),
      disturbance_text(all));
}

/// Of the two schemes on two threads.
const char* compare_schemes(const Reproduction& all, const Ratio& one_by_two) {
  constexpr double kEqual = 1.1;
  const Side low = side_of_threads(all, one_by_two, 1.0 / kEqual);
  const Side high = side_of_threads(all, one_by_two, kEqual);
  if (low == Side::below)
    return "scheme 1 is clearly the faster, where the paper sees little difference";
  if (high == Side::above) return "scheme 2 is clearly the faster, unlike in the paper";
  if (low == Side::above && high == Side::below)
    return "the schemes are about equal, as in the paper";
  return "which scheme is faster is not to be told, for the times vary too much";
}

/// On which side of the second ratio the first one lies.
Side side_of_threads(const Reproduction& all, const Ratio& ratio, const Ratio& other) {
  const Side low = side_of_threads(all, ratio, other.low);
  return low == side_of_threads(all, ratio, other.high) ? low : Side::untold;
}

/// How many of all times have quartiles so far apart, and of how many.
std::pair<int, int> count_wide(const Timings& timings, double factor) {
  int wide = 0, all = 0;
  for (const Work work : {Work::steps, Work::inverse, Work::run})
    for (const compare::Measurement& measurement : timings.all(work))
      if (const auto spread = timings.find(work, measurement.configuration)) {
        ++all;
        if (spread->high > factor * spread->low) ++wide;
      }
  return {wide, all};
}

}  // namespace

std::vector<std::string> doubts_of(const Reproduction& all) {
  constexpr double kWide = 1.5;
  std::vector<std::string> doubts;
  if (all.is_quick) doubts.emplace_back("A quick run: few rounds, so times are rough.");
  if (is_disturbed(all))
    doubts.emplace_back(
        "The machine was busy with other things: times are disturbed, and there is no verdict on "
        "threads.");
  if (const auto [wide, number] = count_wide(all.timings, kWide); wide > 0)
    doubts.push_back(
        fmt::format("Of {}, {} {} quartiles more than a factor of {} apart: there is no verdict "
                    "where that leaves it open.",
                    counted(number, "time"), wide, wide == 1 ? "has" : "have", kWide));
  return doubts;
}

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
      "later by {:.2f} s, and the vibration that remains ({:.3g} m) is {:.1f} times too small. "
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
  const auto one_by_two = all.timings.ratio(Work::steps, scheme(1, 2), scheme(2, 2));
  if (!one_2 || !one_3 || !two_2 || !two_3 || !one_by_two) return kNothing;
  return fmt::format(
      "In the paper the time falls as one over the threads, by 2.77 on three. Here scheme 1 gains "
      "{} on two threads and {} on three, scheme 2 {} and {}; on two threads {}. {}",
      text_of(*one_2), text_of(*one_3), text_of(*two_2), text_of(*two_3),
      compare_schemes(all, *one_by_two), processors_text(all, 3) + disturbance_text(all));
}

std::string remark_on_layers(const Reproduction& all) {
  if (!has_schemes()) return kWithoutOpenMp;
  const auto slower = [&](int number, int inner) {
    return all.timings.ratio(Work::steps, scheme(number, {3, inner}), scheme(number, {3, 1}));
  };
  const auto two = slower(1, 2), four = slower(1, 4), two_2 = slower(2, 2), four_2 = slower(2, 4);
  if (!two || !four || !two_2 || !four_2) return kNothing;
  const char* verdict =
      choose(side_of_threads(all, *two, kGain), "two inner threads gain over one, as in the paper",
             "inner threads gain nothing over 3x1, unlike in the paper",
             "whether inner threads gain is not to be told, for the times vary too much");
  const char* schemes = choose(side_of_threads(all, *four_2, *four),
                               "Unlike in the paper, scheme 2 does not suffer more.",
                               "As in the paper, scheme 2 suffers more from more threads.",
                               "Which scheme suffers more from more threads is not to be told.");
  return fmt::format(
      "The paper finds 3x2 fastest, and scheme 2 on 3x4 some 1.8 times slower than on 3x1. Here "
      "{}: "
      "scheme 1 takes {} times its 3x1 on 3x2 and {} times on 3x4, scheme 2 {} and {} times. {} {} "
      "{}",
      verdict, text_of(*two), text_of(*four), text_of(*two_2), text_of(*four_2), schemes,
      runtime_text(all), processors_text(all, 12) + disturbance_text(all));
}

std::string remark_on_inverse(const Reproduction& all) {
  std::string text = fmt::format(
      "Measured as runs of a graph that has the step's inverse nodes and no others, as often as in "
      "a step; with threads the forks and barriers of these loops are in it. A node inverts one "
      "block of (P 11): assembly, factorisation, and the right-hand sides that Table 2 counts as "
      "effective mass and force. Serially these nodes are {:.0f} % of a step's work, timed node by "
      "node; Table 2 says 98.6 % for the same. ",
      100.0 * all.inverse_share);
  if (!has_schemes()) return text + kWithoutOpenMp;
  const auto four = all.timings.ratio(Work::inverse, scheme(1, {3, 4}), scheme(1, {3, 1}));
  const auto four_2 = all.timings.ratio(Work::inverse, scheme(2, {3, 4}), scheme(2, {3, 1}));
  if (!four || !four_2) return text;
  const Side one = side_of_threads(all, *four, kGain), two = side_of_threads(all, *four_2, kGain);
  const Side both = one == Side::above || two == Side::above ? Side::above
                    : one == two                             ? one
                                                             : Side::untold;
  const char* verdict =
      choose(both, "it falls, as in the paper.",
             "it does not fall with both, unlike in the paper: a node takes a few "
             "microseconds, less than waking a thread.",
             "whether it falls is not to be told, for the times vary too much.");
  return text + fmt::format(
                    "In the paper this part falls with every inner thread. Here 3x4 takes {} "
                    "times what 3x1 takes with scheme 1, {} times with scheme 2: {}{}",
                    text_of(*four), text_of(*four_2), verdict, disturbance_text(all));
}

std::string remark_on_methods(const Reproduction& all) {
  const auto dense = serial(Formulation::subsystem), own = serial(Formulation::structured);
  const auto conventional = all.timings.ratio(Work::steps, serial(Formulation::augmented), dense);
  const auto structured = all.timings.ratio(Work::steps, dense, own);
  const auto chosen = all.timings.ratio(Work::steps, automatic(Formulation::structured), own);
  if (!conventional || !structured || !chosen) return kNothing;
  std::string text = fmt::format(
      "The algorithm's gain is {}: conventional to subsystem is 3.6 in the paper and {} here, "
      "where only the blocks of (P 11) are factorised, not a matrix of 180. ",
      choose(side_of(*conventional, 1.5), "not confirmed", "confirmed", kUntold),
      report::figure(conventional->median, 2));
  const auto layered = best_layered(all);
  text += layered ? remark_on_threads_of_methods(all, *layered) : std::string(kWithoutOpenMp) + ' ';
  text += fmt::format(
      "The structured formulation makes a step {} times faster than the subsystem one, both on "
      "one thread; the executor auto takes {} times that time{}. ",
      report::figure(structured->median, 2), text_of(*chosen),
      choose(side_of_threads(all, *chosen, kGain), ", with threads",
             ": steps of microseconds are best left to one thread", ""));
  if (const auto run = method_times(all).back().run)
    text += fmt::format(
        "An implicit step of {:.3g} s simulates the 20 s in {}; its largest lag differs by {:.2g} "
        "% "
        "from the same model's converged one.",
        all.implicit.step, graph::duration_text(*run), 100.0 * all.implicit.error);
  return text;
}

}  // namespace spoke::reproduce
