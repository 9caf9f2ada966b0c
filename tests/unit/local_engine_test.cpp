// SPDX-License-Identifier: GPL-3.0-or-later
// links: bridge_engine
// Work in processes of this machine: each item is answered once, whatever becomes of the processes.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <csignal>
#include <map>

#include "bridge/engine/batch_files.hpp"
#include "bridge/engine/slurm_engine.hpp"
#include "tests/own_folder.hpp"

namespace blockweir::engine::local_engine_test {
namespace {

using nlohmann::json;

Work numbers(int count) {
  Work work{.name = "numbers", .common = 10, .items = {}};
  for (int i = 0; i < count; ++i) work.items.push_back(i);
  return work;
}

Worker times_common(const json& common) {
  return [common](const json& item) -> json { return item.get<int>() * common.get<int>(); };
}

TEST(LocalEngine, AnswersEachItemOnceWithAnyNumberOfProcesses) {
  for (const int jobs : {1, 2, 7, 60}) {
    std::map<std::size_t, json> answers;
    const Work work = numbers(50);
    ASSERT_TRUE(local_engine(jobs, times_common)->perform(work, [&](std::size_t i, const json& answer) {
      EXPECT_TRUE(answers.emplace(i, answer).second);
    }));
    ASSERT_EQ(answers.size(), 50U) << jobs;
    for (const auto& [i, answer] : answers) EXPECT_EQ(answer, 10 * static_cast<int>(i));
  }
}

TEST(LocalEngine, AnItemThatKillsItsProcessHasNoAnswerAndTheOthersHave) {
  const auto deadly = [](const json&) -> Worker {
    return [](const json& item) -> json {
      if (item == 3 || item == 7) ::kill(::getpid(), SIGKILL);
      return item;
    };
  };
  std::map<std::size_t, json> answers;
  const Work work = numbers(20);
  ASSERT_TRUE(local_engine(2, deadly)->perform(work, [&](std::size_t i, const json& a) { answers[i] = a; }));
  ASSERT_EQ(answers.size(), 20U);
  for (const auto& [i, answer] : answers) EXPECT_EQ(answer.is_null(), i == 3 || i == 7) << i;
}

TEST(LocalEngine, ProcessesThatCannotBeginAreTold) {
  const auto broken = [](const json&) -> Worker { throw std::runtime_error("broken"); };
  const Work work = numbers(3);
  EXPECT_THROW(static_cast<void>(local_engine(2, broken)->perform(work, [](std::size_t, const json&) {})),
               std::runtime_error);
}

/// Asks its task to end, as a queue does all processes of one, and only then answers.
Worker ends_with_its_task(const json&) {
  return [](const json& item) -> json {
    if (item != 2) return item;
    sigset_t term;
    sigemptyset(&term);
    sigaddset(&term, SIGTERM);
    ::sigprocmask(SIG_BLOCK, &term, nullptr);
    ::kill(::getppid(), SIGTERM);
    int signal = 0;
    ::sigwait(&term, &signal);
    return "stopped";
  };
}

TEST(LocalEngine, WhatAnItemAnswersAfterAStopDoesNotCount) {
  std::map<std::size_t, json> answers;
  const Work work = numbers(5);
  EXPECT_FALSE(
      local_engine(1, ends_with_its_task)->perform(work, [&](std::size_t i, const json& a) { answers[i] = a; }));
  EXPECT_FALSE(answers.contains(2));
}

class Batches : public test::OwnFolder {};

TEST_F(Batches, ATaskDoesItsOwnItemsAndNoneTwice) {
  const BatchFiles files(folder);
  const Work work = numbers(5);
  const auto digests = digests_of(work);
  files.write(work.common, 2, digests, work.items);
  std::set<std::string> seen;
  EXPECT_EQ(work_on_batch(folder, 1, times_common), 0);
  const Answers first = files.take(seen);
  EXPECT_EQ(first.by_digest, (std::map<std::string, json>{{digests[2], 20}, {digests[3], 30}}));
  // Killed and begun again: what has been done is known.
  const auto refuse = [](const json&) -> Worker { throw std::runtime_error("nothing is to be done"); };
  EXPECT_EQ(work_on_batch(folder, 1, refuse), 0);
  EXPECT_EQ(work_on_batch(folder, 2, times_common), 0);
  EXPECT_EQ(files.take(seen).by_digest, (std::map<std::string, json>{{digests[4], 40}}));
  EXPECT_THROW(work_on_batch(folder, 3, times_common), std::runtime_error);
  EXPECT_THROW(work_on_batch(folder / "none", 0, times_common), std::runtime_error);
}

TEST_F(Batches, ATaskThatIsToldToEndLeavesItsItemForTheNext) {
  const BatchFiles files(folder);
  const Work work = numbers(5);
  const auto digests = digests_of(work);
  files.write(work.common, 5, digests, work.items);
  EXPECT_EQ(work_on_batch(folder, 0, ends_with_its_task), 1);
  std::set<std::string> seen;
  EXPECT_FALSE(files.take(seen).by_digest.contains(digests[2]));
  EXPECT_EQ(work_on_batch(folder, 0, times_common), 0);
  std::set<std::string> of_the_next;  // this process writes both, under the same names
  EXPECT_EQ(files.take(of_the_next).by_digest[digests[2]], 20);
}

TEST_F(Batches, AFileThatIsNotWholeDoesNotCount) {
  const BatchFiles files(folder);
  std::ofstream(folder / "0-half.answers") << R"({"answers":{"a":1)";
  std::set<std::string> seen;
  EXPECT_TRUE(files.take(seen).by_digest.empty());
}

}  // namespace
}  // namespace blockweir::engine::local_engine_test
