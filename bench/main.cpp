// The program "spoke_bench": measures what Spoke promises, one question a source file. A missed
// target is reported and changes no exit status: time is no test.

#include <spdlog/fmt/fmt.h>

#include <CLI/CLI.hpp>
#include <array>
#include <cstdio>
#include <exception>
#include <fstream>

#include "bench/progress.h"
#include "bench/questions.h"

namespace {

using namespace spoke::bench;

struct Question {
  const char* name;
  const char* text;
  void (*measure)(const QuestionOptions&, Report&);
  bool only_if_named = false;  ///< takes long
};

/// What formulations cost, and what executors gain on the same rotors.
void measure_methods(const QuestionOptions& options, Report& report) {
  measure_formulations(options, report);
  measure_executors(options, report);
}

constexpr std::array kQuestions{
    Question{"formulations_executors",
             "what an evaluation costs by formulation, and a step on two threads by executor",
             measure_methods},
    Question{"models", "what a step of every shipped model takes, and what auto gains there",
             measure_models},
    Question{"time_to_solution", "how long the 20 s spin-up takes at 0.1 % accuracy",
             measure_time_to_solution},
    Question{"growth",
             "how costs grow with size: of loops, chains, rotors and nodal solids, starts, memory",
             measure_growth},
    Question{"peers", "how long problems take that other programs were timed on, by error",
             measure_peers},
    Question{"start_up", "what the program takes beyond its integration", measure_start_up},
    Question{"passes", "how many passes a step needs, at the steps that accuracy allows",
             measure_passes, true}};

struct Arguments {
  std::string filter;
  std::string json;
  QuestionOptions options;
};

std::vector<Question> chosen_questions(const std::string& filter) {
  std::vector<Question> chosen;
  for (const Question& question : kQuestions)
    if (std::string(question.name).find(filter) != std::string::npos &&
        !(filter.empty() && question.only_if_named))
      chosen.push_back(question);
  return chosen;
}

std::string help_footer() {
  std::string text = "Questions:\n";
  for (const Question& question : kQuestions)
    text += fmt::format("  {:<24}{}\n", question.name, question.text);
  return text +
         "\nA whole run takes some minutes, on up to two threads; leave the machine alone "
         "meanwhile.\n\nExit status: 0 done, whether targets were reached or missed; 1 the "
         "alternatives disagree;\n2 bad command line\n";
}

void add_options(CLI::App& program, Arguments& arguments) {
  program.add_option("--filter", arguments.filter, "Only the questions whose name contains NAME")
      ->type_name("NAME")
      ->check([](const std::string& filter) {
        return chosen_questions(filter).empty() ? "no question is named like " + filter
                                                : std::string();
      });
  program.add_option("--json", arguments.json, "Write results, machine and version to FILE, too")
      ->type_name("FILE")
      ->check([](const std::string& file) {  // checked now rather than after minutes
        return std::ofstream(file, std::ios::app) ? std::string() : "cannot write " + file;
      });
  program.add_flag("--quick", arguments.options.quick,
                   "A smoke run of less than a minute: few rounds, slow alternatives left out");
  program.footer(help_footer());
}

void run(const Arguments& arguments) {
  Report report(arguments.options.quick);
  report.print_header();
  for (const Question& question : chosen_questions(arguments.filter)) {
    report.begin_question(question.name, question.text);
    question.measure(arguments.options, report);
  }
  report.print_summary();
  if (!arguments.json.empty()) report.write_json(arguments.json);
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App program("Measures what Spoke promises: ratios of alternatives, timed in turns.",
                   "spoke bench");
  Arguments arguments;
  add_options(program, arguments);
  try {
    program.parse(argc, argv);
    run(arguments);
    return 0;
  } catch (const CLI::ParseError& error) {
    return program.exit(error) == 0 ? 0 : 2;
  } catch (const std::exception& error) {
    show_progress("");
    std::fflush(stdout);
    fmt::print(stderr, "spoke bench: {}\n", error.what());
    return 1;
  }
}
