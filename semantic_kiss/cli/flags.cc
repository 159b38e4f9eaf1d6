// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "semantic_kiss/cli/flags.h"

#include "gflags/gflags.h"
#include "glog/logging.h"

DEFINE_string(box, "", "Corners of a box in the map: x_min,y_min,x_max,y_max in metres.");
DEFINE_string(calib, "",
              "KITTI calib.txt; its row Tr turns lidar poses of --estimate into the camera poses "
              "of KITTI's ground truth. Without it both files must be of the same body.");
DEFINE_string(compare, "", "A second map, which is shown beside the first.");
DEFINE_string(config, "semantic_kiss.lua",
              "Configuration: a Lua file, or the name of one that the program brings along.");
DEFINE_string(dataset, "",
              "Folder in SemanticKITTI's layout: sequences/NN/velodyne/*.bin, and as far as "
              "present labels, confidences, calib.txt, times.txt and poses.");
DEFINE_int32(epoch, 0, "The day: on another one most parked vehicles differ, nothing else.");
DEFINE_string(estimate, "", "Estimated trajectory in KITTI's format, 12 numbers a line.");
DEFINE_int32(first_scan, 0, "Number of the scan to begin with.");
DEFINE_bool(freeze_map, false,
            "With --map: leave the poses of the map as they are and move the new drive alone.");
DEFINE_string(
    ground_truth, "",
    "True trajectory in KITTI's format, 12 numbers a line. For \"run\" the data set's own "
    "by default.");
DEFINE_string(hide, "", "Labels that are left out, separated by commas: car,truck.");
DEFINE_string(initial_pose, "",
              "About where the first scan was taken: x, y in metres and the heading in degrees, as "
              "the map has them from above. Without it all of the map is searched.");
DEFINE_bool(json, false, "Print JSON for scripts instead of text for people.");
DEFINE_string(keep, "", "Labels to keep, separated by commas: all others are removed.");
DEFINE_string(keep_role, "",
              "Roles whose labels are kept: moving, movable, critical, ground, unlabeled.");
DEFINE_string(keep_trajectory, "",
              "Trajectories to keep, separated by commas: only what the others saw is removed.");
DEFINE_double(lane_offset, 0., "Drive so far to the left of the town's planned drive, in metres.");
DEFINE_double(label_noise, 0., "Share of points with a wrong label, up to 0.25.");
DEFINE_string(labels_dir, "",
              "Where the labels are: a folder of the sequence such as `predictions`, an absolute "
              "path (also one with sequences/NN/predictions in it), or `none`.");
DEFINE_double(length, 0., "Length of a synthetic route in metres.");
DEFINE_string(lidar, "", "The lidar: hdl64, os1_128, vlp16, or another one of the configuration.");
DEFINE_string(
    live, "",
    "Show map and figures while they grow, on a page of 127.0.0.1 at this port, or at any "
    "free one; the page's address is printed.");
DEFINE_string(map, "", "Map to read.");
DEFINE_string(map_ground_truth, "",
              "Folder of the sequence that the map was made from: its poses.txt, times.txt and "
              "calib.txt tell where the map's places really are, in the world of --ground_truth.");
DEFINE_int32(min_hits, 0, "Remove cells of a submap that fewer points of a label hit.");
DEFINE_bool(node_clouds, false,
            "Take the points of the nodes, which know intensities, not those of the submaps.");
DEFINE_int32(num_scans, 0, "Number of scans to use.");
DEFINE_string(output, "",
              "Where results go. Existing results are replaced once new ones are whole.");
DEFINE_string(other_map, "", "The map that is joined to --map.");
DEFINE_bool(outside, false, "Remove what is outside of --polygon or --box, not inside.");
DEFINE_string(polygon, "", "Corners of a polygon in the map: x1,y1,x2,y2,... in metres.");
DEFINE_string(poses, "", "Drive the way of this file: camera poses in KITTI's format.");
DEFINE_string(preview, "", "Draw the town from above with the route: a PNG.");
DEFINE_int32(preview_scan, 0, "Draw --preview from the car's view instead, at this scan.");
DEFINE_bool(quiet, false, "Print nothing but errors.");
DEFINE_bool(raw, false, "Leave points as measured, not deskewed, and write their times.");
DEFINE_string(remove, "", "Labels to remove, separated by commas: car,truck.");
DEFINE_string(remove_role, "",
              "Roles whose labels are removed: moving, movable, critical, ground, unlabeled.");
DEFINE_bool(remove_transient, false,
            "Remove movable and unlabeled things that one visit saw and another one did not.");
DEFINE_double(resolution, 0.,
              "Side of a pixel in metres; of point clouds, side of the cubes that hold one point "
              "each, 0: all points.");
DEFINE_string(route, "", "Synthetic route: city, highway or loop.");
DEFINE_int64(seed, 0, "What the town and the lidar's errors are made from.");
DEFINE_string(sequence, "00", "Sequence of the data set.");
DEFINE_string(show, "", "The only labels that are used, separated by commas: building,fence.");
DEFINE_int32(threads, 0, "Number of threads; results do not depend on it.");
DEFINE_double(speed_factor, 1., "Drive at so many times the speed of the town's planned drive.");
DEFINE_string(trace_scan, "",
              "Scans whose way through every stage is told, by their numbers, separated by commas: "
              "frames, points in and out, labels, time, outcome.");
DEFINE_string(trajectory, "", "Trajectories, by their numbers, separated by commas.");

namespace semantic_kiss::cli {

const std::vector<FlagInfo>& Flags() {
  using G = FlagGroup;
  using V = FlagValue;
  static const auto& flags = *new std::vector<FlagInfo>{
      {"config", "FILE", G::kInput, V::kFile},
      {"dataset", "DIR", G::kInput, V::kDirectory},
      {"sequence", "NN", G::kInput, V::kText},
      {"map", "FILE", G::kInput, V::kFile},
      {"other_map", "FILE", G::kInput, V::kFile},
      {"compare", "FILE", G::kInput, V::kFile},
      {"ground_truth", "FILE", G::kInput, V::kFile},
      {"estimate", "FILE", G::kInput, V::kFile},
      {"route", "KIND", G::kInput, V::kText, "as configured"},
      {"poses", "FILE", G::kInput, V::kFile},
      {"lidar", "NAME", G::kInput, V::kText, "as configured"},
      {"calib", "FILE", G::kInput, V::kFile},
      {"labels_dir", "DIR", G::kInput, V::kDirectory, "labels, if there are any"},
      {"map_ground_truth", "DIR", G::kInput, V::kDirectory},
      {"initial_pose", "X,Y,DEG", G::kInput, V::kText, "anywhere"},
      {"freeze_map", "", G::kSelection, V::kNone},
      {"first_scan", "N", G::kSelection, V::kNumber, "the first", 0.},
      {"num_scans", "N", G::kSelection, V::kNumber, "all", 0.},
      {"length", "M", G::kSelection, V::kNumber, "as configured", 0.},
      {"seed", "N", G::kSelection, V::kNumber, "as configured", 0.},
      {"epoch", "N", G::kSelection, V::kNumber, "as configured", 0.},
      {"lane_offset", "M", G::kSelection, V::kNumber, "as configured"},
      {"speed_factor", "F", G::kSelection, V::kNumber, "as configured", 0.},
      {"label_noise", "SHARE", G::kSelection, V::kNumber, "as configured", 0.},
      {"hide", "LABELS", G::kSelection, V::kText},
      {"show", "LABELS", G::kSelection, V::kText, "all"},
      {"node_clouds", "", G::kSelection, V::kNone},
      {"remove", "LABELS", G::kSelection, V::kText},
      {"remove_role", "ROLES", G::kSelection, V::kText},
      {"keep", "LABELS", G::kSelection, V::kText},
      {"keep_role", "ROLES", G::kSelection, V::kText},
      {"min_hits", "N", G::kSelection, V::kNumber, "all cells stay", 0.},
      {"remove_transient", "", G::kSelection, V::kNone},
      {"polygon", "NUMBERS", G::kSelection, V::kText, "everywhere"},
      {"box", "NUMBERS", G::kSelection, V::kText, "everywhere"},
      {"outside", "", G::kSelection, V::kNone},
      {"trajectory", "NUMBERS", G::kSelection, V::kText, "all"},
      {"keep_trajectory", "NUMBERS", G::kSelection, V::kText},
      {"output", "PATH", G::kOutput, V::kFile},
      {"trace_scan", "NUMBERS", G::kOutput, V::kText, "none"},
      {"raw", "", G::kOutput, V::kNone},
      {"preview", "FILE", G::kOutput, V::kFile},
      {"preview_scan", "N", G::kOutput, V::kNumber, "the town from above", 0.},
      {"resolution", "M", G::kOutput, V::kNumber, "as configured", 0., 100.},
      {"json", "", G::kOutput, V::kNone},
      {"threads", "N", G::kExecution, V::kNumber, "all cores", 0., 1024.},
      {"live", "PORT", G::kExecution, V::kNumber, "no page", 0., 65535., "0"},
      {"quiet", "", G::kExecution, V::kNone},
  };
  return flags;
}

const FlagInfo& FlagNamed(const std::string& name) {
  for (const FlagInfo& flag : Flags()) {
    if (flag.name == name) return flag;
  }
  LOG(FATAL) << "no flag is called " << name;
}

std::vector<std::string> WordsOfFlag(const std::string& name) {
  if (name == "route") return {"city", "highway", "loop"};
  if (name == "lidar") return {"hdl64", "os1_128", "vlp16"};
  if (name == "labels_dir") return {"none", "predictions"};
  if (name == "keep_role" || name == "remove_role") {
    return {"moving", "movable", "critical", "ground", "unlabeled"};
  }
  return {};
}

bool IsGiven(const std::string& flag) {
  return !gflags::GetCommandLineFlagInfoOrDie(flag.c_str()).is_default;
}

}  // namespace semantic_kiss::cli
