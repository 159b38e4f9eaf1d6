// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#ifndef SEMANTIC_KISS_LIVE_SERVER_H_
#define SEMANTIC_KISS_LIVE_SERVER_H_

#include <functional>
#include <memory>
#include <string>

#include "absl/status/statusor.h"
#include "cartographer/sensor/label_set.h"
#include "semantic_kiss/live/board.h"

namespace semantic_kiss::live {

// Shows a run to browsers of this machine: http://127.0.0.1:PORT/, nowhere else. Read-only:
// whatever is not GET is refused (405), and so is whatever does not call us by 127.0.0.1 or
// localhost (403), lest a page from elsewhere look on by a name of its own (DNS rebinding).
//
//   /             the page
//   /state.json   {phase, snapshot (snapshot_json.h) or null, picture or null: {version, min_x,
//                 max_y, resolution, width, height}}
//   /map.png      the map from above
//   /report.html  the run's report, once there is one
class Server {
 public:
  // `port` 0: any that is free. `board` must outlive the server; `report_path` is where the run
  // puts its report. Errors: a port that is taken.
  static absl::StatusOr<std::unique_ptr<Server>> Start(int port, Board* board,
                                                       const cartographer::sensor::LabelSet& labels,
                                                       const std::string& report_path);

  Server(const Server&) = delete;
  Server& operator=(const Server&) = delete;
  // Ends what is being answered, then the server.
  ~Server();

  int port() const;
  std::string url() const;

  // Tells those who look that the run has come to its end, and gives them time to fetch the report:
  // returns at once if nobody looks, else when all have it, or `impatient` says so, or after some
  // seconds.
  void Conclude(Phase phase, const std::function<bool()>& impatient);

 private:
  class Impl;
  explicit Server(std::unique_ptr<Impl> impl);

  const std::unique_ptr<Impl> impl_;
};

}  // namespace semantic_kiss::live

#endif  // SEMANTIC_KISS_LIVE_SERVER_H_
