// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "semantic_kiss/live/server.h"

#include <httplib.h>

#include <chrono>
#include <fstream>
#include <sstream>
#include <thread>
#include <utility>

#include "absl/strings/str_cat.h"
#include "semantic_kiss/live/live_page.h"
#include "semantic_kiss/live/map_feed.h"
#include "semantic_kiss/live/snapshot_json.h"
#include "semantic_kiss/report/json_text.h"

namespace semantic_kiss::live {
namespace {

using Handled = httplib::Server::HandlerResponse;

constexpr char kAddress[] = "127.0.0.1";
constexpr int kThreads = 4;
constexpr int kKeepAlive_s = 2;
constexpr double kPatience_s = 10.;
constexpr auto kBetweenLooks = std::chrono::milliseconds(50);
constexpr char kHtml[] = "text/html; charset=utf-8";

double SteadySeconds() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

std::string ReadFile(const std::string& path) {
  std::ostringstream content;
  content << std::ifstream(path, std::ios::binary).rdbuf();
  return content.str();
}

void Refuse(int status, const char* why, httplib::Response* response) {
  response->status = status;
  response->set_content(absl::StrCat(why, "\n"), "text/plain");
}

// Another program that listens on the port is an error: the library's own default would share it.
void ReuseOnlyClosedPorts(socket_t socket) {
  const int yes = 1;
  setsockopt(socket, SOL_SOCKET, SO_REUSEADDR, &yes, sizeof yes);
}

}  // namespace

class Server::Impl {
 public:
  Impl(Board* board, const cartographer::sensor::LabelSet& labels, const std::string& report_path)
      : board_(*board), feed_(labels, &SteadySeconds), report_path_(report_path) {
    server_.new_task_queue = [] { return new httplib::ThreadPool(kThreads); };
    server_.set_keep_alive_timeout(kKeepAlive_s);
    server_.set_payload_max_length(0);
    server_.set_socket_options(&ReuseOnlyClosedPorts);
    server_.set_default_headers({{"Cache-Control", "no-store"},
                                 {"X-Content-Type-Options", "nosniff"},
                                 {"Cross-Origin-Resource-Policy", "same-origin"}});
    server_.set_pre_routing_handler([this](const auto& request, auto& response) {
      return Admit(request, &response) ? Handled::Unhandled : Handled::Handled;
    });
    Route();
  }

  ~Impl() {
    server_.stop();
    if (thread_.joinable()) thread_.join();
  }

  absl::Status Listen(int port) {
    if (port == 0) {
      port_ = server_.bind_to_any_port(kAddress);
    } else if (server_.bind_to_port(kAddress, port)) {
      port_ = port;
    }
    if (port_ <= 0) {
      return absl::UnavailableError(absl::StrCat("--live: port ", port, " of ", kAddress,
                                                 " cannot be had; another program may use it; "
                                                 "without a number any free one is taken"));
    }
    thread_ = std::thread([this] { server_.listen_after_bind(); });
    while (!server_.is_running()) std::this_thread::yield();
    return absl::OkStatus();
  }

  int port() const { return port_; }
  Board& board() { return board_; }

 private:
  bool Admit(const httplib::Request& request, httplib::Response* response) const {
    const std::string host = request.get_header_value("Host");
    // The port that is HTTP's own is not named by those who call.
    const std::string suffix = port_ == 80 ? "" : absl::StrCat(":", port_);
    if (host != absl::StrCat(kAddress, suffix) && host != absl::StrCat("localhost", suffix)) {
      Refuse(403, "this page is for 127.0.0.1 alone", response);
      return false;
    }
    if (request.method != "GET" && request.method != "HEAD") {
      response->set_header("Allow", "GET, HEAD");
      Refuse(405, "a run can be looked at, not changed", response);
      return false;
    }
    return true;
  }

  void Route() {
    server_.Get("/", [](const auto&, auto& response) { response.set_content(LivePage(), kHtml); });
    server_.Get("/state.json", [this](const auto& request, auto& response) {
      board_.Saw(request.get_param_value("viewer"));
      response.set_content(report::JsonText(StateJson()), "application/json");
    });
    server_.Get("/map.png", [this](const auto&, auto& response) {
      std::string png = feed_.Png();
      if (png.empty()) return Refuse(404, "nothing is drawn yet", &response);
      response.set_content(std::move(png), "image/png");
    });
    server_.Get("/report.html", [this](const auto& request, auto& response) {
      if (!Ended()) return Refuse(404, "the run goes on", &response);
      response.set_content(ReadFile(report_path_), kHtml);
      board_.Served(request.get_param_value("viewer"));
    });
  }

  bool Ended() const { return board_.phase() == Phase::kDone || board_.phase() == Phase::kStopped; }

  nlohmann::ordered_json StateJson() {
    const std::shared_ptr<const Snapshot> snapshot = board_.Look();
    if (snapshot != nullptr) feed_.Update(*snapshot);
    return {{"phase", NameOf(board_.phase())},
            {"snapshot", snapshot != nullptr ? SnapshotJson(*snapshot) : nlohmann::ordered_json()},
            {"picture", feed_.Description()}};
  }

  Board& board_;
  MapFeed feed_;
  const std::string report_path_;
  httplib::Server server_;
  int port_ = 0;
  std::thread thread_;
};

absl::StatusOr<std::unique_ptr<Server>> Server::Start(int port, Board* board,
                                                      const cartographer::sensor::LabelSet& labels,
                                                      const std::string& report_path) {
  auto impl = std::make_unique<Impl>(board, labels, report_path);
  const absl::Status status = impl->Listen(port);
  if (!status.ok()) return status;
  return std::unique_ptr<Server>(new Server(std::move(impl)));
}

Server::Server(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}

Server::~Server() = default;

int Server::port() const { return impl_->port(); }

std::string Server::url() const { return absl::StrCat("http://", kAddress, ":", port(), "/"); }

void Server::Conclude(Phase phase, const std::function<bool()>& impatient) {
  Board& board = impl_->board();
  board.SetPhase(phase);
  const double end_s = SteadySeconds() + kPatience_s;
  while (board.NumWaiting() > 0 && !impatient() && SteadySeconds() < end_s) {
    std::this_thread::sleep_for(kBetweenLooks);
  }
}

}  // namespace semantic_kiss::live
