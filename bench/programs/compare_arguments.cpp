// Parses the lists of executors, threads, formulations and OpenMP settings.

#include "bench/programs/compare_arguments.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <charconv>
#include <functional>
#include <span>
#include <sstream>

#include "program/cli/threads_option.h"
#include "program/cli/word_list.h"

namespace spoke::cli {
namespace {

constexpr int kMostRounds = 10000;
constexpr std::array kWaits{compare::Wait::runtime_default, compare::Wait::passive,
                            compare::Wait::active};

/// A value and its name.
template <class Value>
struct Choice {
  std::string name;
  Value value;
};

template <class Value>
Value choose(const std::string& option, const std::string& name,
             const std::vector<Choice<Value>>& choices) {
  std::string known;
  for (const Choice<Value>& choice : choices) {
    if (choice.name == name) return choice.value;
    known += (known.empty() ? "" : ", ") + choice.name;
  }
  const bool lacks_openmp = option == "--executors" && name.starts_with("openmp") &&
                            known.find("openmp") == std::string::npos;
  throw CLI::ValidationError(
      option, (lacks_openmp ? name + ": this build has no OpenMP" : "unknown \"" + name + '"') +
                  ", expected some of " + known);
}

template <class Value>
void append_once(std::vector<Value>& list, Value value) {
  if (std::find(list.begin(), list.end(), value) == list.end()) list.push_back(value);
}

/// Adds an option that takes a list of words, or "all" if there are values that this means.
template <class Value>
void add_list(CLI::App& command, const std::string& option, const std::string& text,
              std::vector<Value>& list, std::function<Value(const std::string&)> parse,
              const std::vector<Value>& all = {}) {
  command
      .add_option_function<std::string>(
          option,
          [&list, parse, all](const std::string& words) {
            list.clear();
            if (words == "all" && !all.empty()) {
              list = all;
              return;
            }
            for (const std::string& word : split_words(words)) append_once(list, parse(word));
          },
          text)
      ->type_name("A,B,...");
}

template <class Value>
void add_choices(CLI::App& command, const std::string& option, const std::string& text,
                 std::vector<Value>& list, const std::vector<Choice<Value>>& choices) {
  constexpr std::size_t kWidth = 64;  // width of the column in which --help explains options
  std::string known = "\nof ", separator;
  std::vector<Value> all;
  std::size_t line = 0;  // begin of the last line
  for (const auto& choice : choices) {
    known += separator;
    if (known.size() - line + choice.name.size() > kWidth) {
      line = known.size();
      known.back() = '\n';
    }
    known += choice.name;
    separator = ", ";
    all.push_back(choice.value);
  }
  add_list<Value>(
      command, option, text + known, list,
      [option, choices](const std::string& word) { return choose(option, word, choices); }, all);
}

template <class Value>
std::vector<Choice<Value>> choices_of(std::span<const Value> values) {
  std::vector<Choice<Value>> choices;
  for (const Value value : values) choices.push_back({std::string(name_of(value)), value});
  return choices;
}

compare::Spin parse_spin(const std::string& word) {
  using compare::Spin;
  for (const Spin named : {Spin{}, Spin{Spin::kInfinite}})
    if (word == name_of(named)) return named;
  std::int64_t count = 0;
  const char* const last = word.data() + word.size();
  const auto [end, fault] = std::from_chars(word.data(), last, count);
  if (fault != std::errc{} || end != last || count < 0 || count > Spin::kMost)
    throw CLI::ValidationError("--spin", "expected default, infinite or a count from 0 to " +
                                             name_of(Spin{Spin::kMost}) + ", got \"" + word + '"');
  return {count};
}

}  // namespace

void add_compare_options(CLI::App& command, CompareArguments& arguments) {
  compare::Axes& axes = arguments.axes;
  add_choices<Formulation>(command, "--formulations", "Formulations [structured,subsystem]",
                           axes.formulations, choices_of(formulations()));
  add_choices(command, "--executors", "Executors, besides serial [all]", axes.executors,
              choices_of(graph::executor_kinds()));
  add_list<graph::Threads>(command, "--threads",
                           "Numbers of threads, OUTERxINNER for executors with nested teams\n"
                           "[powers of two up to the processors available; a thread per blade]",
                           axes.threads, parse_threads_option);
  add_choices<compare::Wait>(command, "--wait",
                             "How idle threads of OpenMP wait\n[all; default, with a spin count]",
                             axes.waits, choices_of<compare::Wait>(kWaits));
  add_list<compare::Spin>(command, "--spin",
                          "How many times idle threads of OpenMP look for work before they\n"
                          "sleep, or infinite; default: as --wait says [default]",
                          axes.spins, parse_spin);
  add_choices<bool>(command, "--bind", "Whether OpenMP binds threads to processors [false]",
                    axes.binds, {{"false", false}, {"true", true}});
  command.add_option("--repeat", arguments.rounds, "Rounds [20]")
      ->check(CLI::Range(1, kMostRounds))
      ->type_name("N");
}

}  // namespace spoke::cli
