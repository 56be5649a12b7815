#include "bench/compare/child.h"

#include <doctest/doctest.h>
#include <signal.h>

#include <chrono>
#include <iostream>
#include <memory>

using namespace spoke::compare;
using Kind = Answer::Kind;

namespace {

Command shell(const std::string& script) { return {"/bin/sh", {"-c", script}, {"A=value"}}; }

bool is_alive(const std::string& process) { return kill(std::stoi(process), 0) == 0; }

}  // namespace

TEST_CASE("a child answers lines with lines, in its own environment") {
  Child child(shell("while read word; do echo \"$A $word\"; echo next; done"));
  for (const char* word : {"one", "two"}) {
    child.send(word);
    const Answer answer = child.receive(10.0);
    CHECK(answer.kind == Kind::line);
    CHECK(answer.text == std::string("value ") + word);
    CHECK(child.receive(10.0).text == "next");
  }
}

TEST_CASE("a child finds its input before all lines") {
  Command command = shell("cat");
  command.input = "first\nse";
  Child child(command);
  child.send("cond");
  CHECK(child.receive(10.0).text == "first");
  CHECK(child.receive(10.0).text == "second");
}

TEST_CASE("a child that says nothing is late, and one that ends has ended") {
  Child silent(shell("sleep 100"));
  const auto begin = std::chrono::steady_clock::now();
  CHECK(silent.receive(0.1).kind == Kind::late);
  CHECK(std::chrono::steady_clock::now() - begin < std::chrono::seconds(10));
  Child ended(shell("echo last"));
  CHECK(ended.receive(10.0).text == "last");
  CHECK(ended.receive(10.0).kind == Kind::ended);
  ended.send("into nothing");
  ended.halt();
  ended.go_on();
  std::cout.flush();  // the thread sanitizer's _exit() would write what is left, twice
  CHECK(Child({"/no/such/program", {}, {}}).receive(10.0).kind == Kind::ended);
}

TEST_CASE("a halted child does nothing until it goes on") {
  Child child(shell("while read word; do echo $word; done"));
  child.halt();
  child.send("word");
  CHECK(child.receive(0.1).kind == Kind::late);
  child.go_on();
  CHECK(child.receive(10.0).text == "word");
}

TEST_CASE("a child dies with its handle, halted or not") {
  for (const bool halted : {false, true}) {
    auto child = std::make_unique<Child>(shell("echo $$; exec sleep 100"));
    const std::string process = child->receive(10.0).text;
    REQUIRE(is_alive(process));
    if (halted) child->halt();
    child.reset();
    CHECK_FALSE(is_alive(process));
  }
}
