// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "semantic_kiss/live/server.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <httplib.h>

#include <atomic>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <thread>
#include <vector>

#include "glog/logging.h"
#include "test/testing/map_sketch.h"
#include "test/testing/test_files.h"

namespace semantic_kiss::live {
namespace {

using semantic_kiss_testing::SketchLabels;
using ::testing::HasSubstr;

std::shared_ptr<const Snapshot> SomeSnapshot(int done) {
  auto snapshot = std::make_shared<Snapshot>();
  snapshot->done = done;
  snapshot->total = 100;
  snapshot->path.assign(done, Eigen::Vector2d(1.26, -2.));
  snapshot->submaps[{0, 0}] = {{}, semantic_kiss_testing::SubmapFromSketch({"RB"}, 0.4)};
  return snapshot;
}

class ServerTest : public ::testing::Test {
 protected:
  ServerTest() {
    auto server = Server::Start(0, &board_, SketchLabels(), directory_ / "report.html");
    CHECK(server.ok()) << server.status();
    server_ = *std::move(server);
    client_ = std::make_unique<httplib::Client>("127.0.0.1", server_->port());
  }

  int StatusOf(const std::string& path) { return client_->Get(path)->status; }
  nlohmann::json State() {
    return nlohmann::json::parse(client_->Get("/state.json?viewer=a")->body);
  }

  semantic_kiss_testing::TemporaryDirectory directory_;
  Board board_{[] { return 0.; }};
  std::unique_ptr<Server> server_;
  std::unique_ptr<httplib::Client> client_;
};

TEST_F(ServerTest, ServesThePage) {
  const auto page = client_->Get("/");
  EXPECT_EQ(page->status, 200);
  EXPECT_THAT(page->body, HasSubstr("default-src 'none'"));
  EXPECT_THAT(page->body, HasSubstr("</html>"));
  EXPECT_EQ(StatusOf("/other"), 404);
}

TEST_F(ServerTest, TellsHowFarTheRunIs) {
  EXPECT_TRUE(State()["snapshot"].is_null());
  EXPECT_EQ(StatusOf("/map.png"), 404);
  EXPECT_TRUE(board_.Wanted());
  board_.Put(SomeSnapshot(7));
  const auto state = State();
  EXPECT_EQ(state["phase"], "driving");
  EXPECT_EQ(state["snapshot"]["done"], 7);
  EXPECT_EQ(state["snapshot"]["path"]["x"].size(), 7u);
  EXPECT_EQ(state["snapshot"]["path"]["x"][0], 1.3);
  EXPECT_EQ(state["picture"]["version"], 1);
  const auto picture = client_->Get("/map.png");
  EXPECT_EQ(picture->get_header_value("Content-Type"), "image/png");
  EXPECT_THAT(picture->body, HasSubstr("IHDR"));
}

TEST_F(ServerTest, CanOnlyBeRead) {
  for (const auto& answer :
       {client_->Post("/", "x", "text/plain"), client_->Put("/state.json", "x", "text/plain"),
        client_->Delete("/map.png"), client_->Options("/")}) {
    ASSERT_TRUE(answer);
    EXPECT_EQ(answer->status, 405);
    EXPECT_EQ(answer->get_header_value("Allow"), "GET, HEAD");
  }
  EXPECT_EQ(client_->Head("/")->status, 200);
}

TEST_F(ServerTest, AnswersToItsOwnNamesAlone) {
  const std::string port = std::to_string(server_->port());
  for (const std::string& name : {"127.0.0.1:" + port, "localhost:" + port}) {
    EXPECT_EQ(client_->Get("/state.json", {{"Host", name}})->status, 200) << name;
  }
  for (const std::string& name :
       {"rebound.example:" + port, std::string("127.0.0.1:1"), std::string("127.0.0.1")}) {
    EXPECT_EQ(client_->Get("/state.json", {{"Host", name}})->status, 403) << name;
  }
}

TEST_F(ServerTest, APortIsNotShared) {
  const auto other = Server::Start(server_->port(), &board_, SketchLabels(), "");
  EXPECT_THAT(std::string(other.status().message()),
              HasSubstr("port " + std::to_string(server_->port())));
}

TEST_F(ServerTest, NobodyLooksNobodyIsWaitedFor) {
  bool asked = false;
  server_->Conclude(Phase::kDone, [&] { return asked = true; });
  EXPECT_FALSE(asked);
}

TEST_F(ServerTest, WaitsUntilThoseWhoLookHaveTheReport) {
  semantic_kiss_testing::WriteText(directory_ / "report.html", "<p>found");
  board_.Saw("a");
  EXPECT_EQ(StatusOf("/report.html"), 404);
  std::atomic<bool> concluded{false};
  std::thread run([&] {
    server_->Conclude(Phase::kStopped, [] { return false; });
    concluded = true;
  });
  while (board_.phase() != Phase::kStopped) std::this_thread::yield();
  EXPECT_FALSE(concluded);
  EXPECT_EQ(client_->Get("/report.html?viewer=a")->body, "<p>found");
  run.join();
}

TEST_F(ServerTest, CanBeAskedFromManyThreadsWhileTheRunGoesOn) {
  std::atomic<bool> ended{false};
  std::vector<std::thread> viewers;
  for (int i = 0; i < 3; ++i) {
    viewers.emplace_back([&] {
      httplib::Client client("127.0.0.1", server_->port());
      while (!ended) {
        EXPECT_EQ(client.Get("/state.json")->status, 200);
        EXPECT_NE(client.Get("/map.png")->status, 500);
      }
    });
  }
  for (int done = 1; done <= 50;) {
    if (board_.Wanted() || done > 1) board_.Put(SomeSnapshot(done++));
  }
  ended = true;
  for (std::thread& viewer : viewers) viewer.join();
  EXPECT_EQ(State()["snapshot"]["done"], 50);
}

}  // namespace
}  // namespace semantic_kiss::live
