// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include <filesystem>
#include <string>
#include <vector>

#include "absl/strings/ascii.h"
#include "absl/strings/str_cat.h"
#include "absl/strings/str_join.h"
#include "absl/strings/str_split.h"
#include "cartographer/common/status.h"
#include "cartographer/io/map_image.h"
#include "cartographer/io/map_reader.h"
#include "semantic_kiss/cli/commands.h"
#include "semantic_kiss/cli/configuration.h"
#include "semantic_kiss/cli/flags.h"

namespace semantic_kiss::cli {
namespace {

namespace io = cartographer::io;
using cartographer::map::Map;

// A kind of file that maps can be rendered to.
struct Format {
  const char* extension;
  absl::Status (*write)(const Map& map, const io::proto::RenderOptions& options,
                        const std::string& path);
};
constexpr Format kFormats[] = {{".png", &io::WriteMapImage}};

absl::StatusOr<Format> FormatOf(const std::string& path) {
  const std::string extension = std::filesystem::path(path).extension().string();
  std::vector<std::string> known;
  for (const Format& format : kFormats) {
    if (format.extension == extension) return format;
    known.push_back(format.extension);
  }
  return absl::InvalidArgumentError(absl::StrCat("--output=", path, ": cannot render to \"",
                                                 extension,
                                                 "\"; supported: ", absl::StrJoin(known, ", ")));
}

// The configured options with what the flags change.
absl::StatusOr<io::proto::RenderOptions> RenderOptions(const Map& map) {
  ASSIGN_OR_RETURN(const Configuration configuration, LoadConfiguration(FLAGS_config));
  io::proto::RenderOptions options = configuration.options.map_image();
  if (FLAGS_resolution > 0.) options.set_resolution_m(FLAGS_resolution);
  for (const absl::string_view part : absl::StrSplit(FLAGS_hide, ',', absl::SkipWhitespace())) {
    const std::string name(absl::StripAsciiWhitespace(part));
    const auto label = map.labels.FromName(name);
    if (!label.ok()) return cartographer::common::AddContext(label.status(), "--hide");
    options.add_hide(name);
  }
  return options;
}

absl::Status RunRender() {
  ASSIGN_OR_RETURN(const Format format, FormatOf(FLAGS_output));
  ASSIGN_OR_RETURN(const Map map, io::ReadMap(FLAGS_map));
  ASSIGN_OR_RETURN(const io::proto::RenderOptions options, RenderOptions(map));
  return format.write(map, options, FLAGS_output);
}

}  // namespace

Command RenderCommand() {
  Command command;
  command.name = "render";
  command.summary = "draw a map";
  command.description =
      "Draws a map from above in the colours of its labels, with scale bar, legend and trajectory; "
      "--output=X.png. Maps of Cartographer are drawn as well. Labels that are hidden are left "
      "out: "
      "what lies beneath them shows.";
  command.flags = {{"map", true},    {"config"},     {"hide"},
                   {"output", true}, {"resolution"}, {"threads"}};
  command.examples = {
      {"The streets without the cars",
       "render --map=map.pbstream --output=map.png --hide=car,truck"},
      {"5 cm a pixel", "render --map=map.pbstream --output=large.png --resolution=0.05"}};
  command.run = &RunRender;
  return command;
}

}  // namespace semantic_kiss::cli
