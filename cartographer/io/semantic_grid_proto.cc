// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "cartographer/io/semantic_grid_proto.h"

#include <cstdint>
#include <cstdlib>
#include <optional>
#include <string>

#include "absl/strings/str_cat.h"
#include "absl/strings/string_view.h"
#include "cartographer/common/status.h"

namespace cartographer::io {
namespace {

using submap::SemanticGrid;

// Bounds of cells in such tiles still fit an int.
constexpr int64_t kMaxTileIndex = int64_t{1} << 26;
constexpr double kMinResolution_m = 1e-3;
constexpr double kMaxResolution_m = 1e3;

constexpr int kCellsPerTile = SemanticGrid::kTileSize * SemanticGrid::kTileSize;
constexpr int kMaskBytes = kCellsPerTile / 8;

void AppendVarint(uint32_t value, std::string* bytes) {
  for (; value >= 0x80; value >>= 7) bytes->push_back(static_cast<char>(value | 0x80));
  bytes->push_back(static_cast<char>(value));
}

// Takes a count of hits from the front of `bytes`; nullopt if there is no valid one.
std::optional<uint16_t> TakeHits(absl::string_view* bytes) {
  uint32_t value = 0;
  for (size_t i = 0; i < std::min<size_t>(3, bytes->size()); ++i) {
    const auto byte = static_cast<uint8_t>((*bytes)[i]);
    value |= static_cast<uint32_t>(byte & 0x7f) << (7 * i);
    if (byte >= 0x80) continue;
    bytes->remove_prefix(i + 1);
    if (value < 1 || value > SemanticGrid::kMaxHits) return std::nullopt;
    return static_cast<uint16_t>(value);
  }
  return std::nullopt;
}

void AppendTile(const SemanticGrid::Tile& tile, map::proto::SemanticLayer* layer) {
  std::string mask(kMaskBytes, '\0');
  for (int cell = 0; cell < kCellsPerTile; ++cell) {
    if (tile.hits[cell] == 0) continue;
    mask[cell / 8] = static_cast<char>(mask[cell / 8] | 1 << cell % 8);
    AppendVarint(tile.hits[cell], layer->mutable_hits());
  }
  layer->mutable_hit_cells()->append(mask);
}

// Fills a tile from its mask; takes its hits from the front of `hits`. False if they are invalid.
bool ReadTile(absl::string_view mask, absl::string_view* hits, SemanticGrid::Tile* tile) {
  for (int cell = 0; cell < kCellsPerTile; ++cell) {
    if ((mask[cell / 8] >> cell % 8 & 1) == 0) continue;
    const std::optional<uint16_t> value = TakeHits(hits);
    if (!value.has_value()) return false;
    tile->hits[cell] = *value;
  }
  return true;
}

bool InRange(int64_t x, int64_t y) {
  return std::abs(x) <= kMaxTileIndex && std::abs(y) <= kMaxTileIndex;
}

absl::Status LayerToProto(const SemanticGrid::Layer& layer, map::proto::SemanticLayer* proto) {
  SemanticGrid::TileIndex previous;
  for (const auto& [index, tile] : layer) {
    if (!InRange(index.x, index.y)) {
      return absl::InvalidArgumentError("a cell lies too far from the submap's origin");
    }
    proto->add_tile_x_deltas(index.x - previous.x);
    proto->add_tile_y_deltas(index.y - previous.y);
    previous = index;
    AppendTile(*tile, proto);
  }
  return absl::OkStatus();
}

absl::Status CheckSizes(const map::proto::SemanticLayer& proto, size_t tiles_so_far) {
  const size_t num_tiles = proto.tile_x_deltas_size();
  if (num_tiles + tiles_so_far > kMaxTiles) {
    return absl::DataLossError(absl::StrCat("more than ", kMaxTiles, " tiles"));
  }
  if (proto.tile_y_deltas_size() == num_tiles &&
      proto.hit_cells().size() == num_tiles * kMaskBytes) {
    return absl::OkStatus();
  }
  return absl::DataLossError(absl::StrCat(num_tiles, " tiles, but ", proto.tile_y_deltas_size(),
                                          " y positions and ", proto.hit_cells().size(),
                                          " bytes of hit cells"));
}

absl::Status ReadLayer(const map::proto::SemanticLayer& proto, SemanticGrid* grid) {
  RETURN_IF_ERROR(CheckSizes(proto, grid->num_tiles()));
  const sensor::Label label{static_cast<uint8_t>(proto.label())};
  absl::string_view hits = proto.hits();
  SemanticGrid::TileIndex previous;
  for (int i = 0; i < proto.tile_x_deltas_size(); ++i) {
    const int64_t x = int64_t{previous.x} + proto.tile_x_deltas(i);
    const int64_t y = int64_t{previous.y} + proto.tile_y_deltas(i);
    if (!InRange(x, y)) return absl::DataLossError(absl::StrCat("tile ", i, " is out of range"));
    const SemanticGrid::TileIndex index{static_cast<int>(x), static_cast<int>(y)};
    if (i > 0 && !(previous < index)) {
      return absl::DataLossError(absl::StrCat("tile ", i, " is out of order"));
    }
    SemanticGrid::Tile tile;
    const absl::string_view hit_cells = proto.hit_cells();
    if (!ReadTile(hit_cells.substr(i * size_t{kMaskBytes}, kMaskBytes), &hits, &tile)) {
      return absl::DataLossError(absl::StrCat("tile ", i, " has invalid counts of hits"));
    }
    grid->SetTile(label, index, tile);
    previous = index;
  }
  return hits.empty() ? absl::OkStatus()
                      : absl::DataLossError("more counts of hits than hit cells");
}

absl::Status CheckLabel(int64_t label, int64_t previous_label, size_t num_labels) {
  if (label >= static_cast<int64_t>(num_labels)) {
    return absl::DataLossError(absl::StrCat("not in the label set of ", num_labels));
  }
  return label > previous_label ? absl::OkStatus() : absl::DataLossError("out of order");
}

absl::Status CheckResolution(double resolution_m) {
  // Written so that NaN fails, too.
  if (resolution_m >= kMinResolution_m && resolution_m <= kMaxResolution_m) return absl::OkStatus();
  return absl::DataLossError(
      absl::StrCat("a grid with cells of ", resolution_m, " m, outside [0.001, 1000]"));
}

}  // namespace

absl::StatusOr<map::proto::SemanticGrid> ToProto(const SemanticGrid& grid, size_t num_labels) {
  map::proto::SemanticGrid proto;
  RETURN_IF_ERROR(CheckResolution(grid.resolution_m()));
  if (grid.num_tiles() > kMaxTiles) {
    return absl::InvalidArgumentError(absl::StrCat(grid.num_tiles(), " tiles are over the ",
                                                   kMaxTiles, " that a submap may have"));
  }
  proto.set_resolution_m(grid.resolution_m());
  for (const sensor::Label label : grid.Labels()) {
    map::proto::SemanticLayer* const layer = proto.add_layers();
    layer->set_label(static_cast<uint32_t>(sensor::Index(label)));
    absl::Status status = CheckLabel(layer->label(), -1, num_labels);
    if (status.ok()) status = LayerToProto(grid.LayerOf(label), layer);
    RETURN_IF_ERROR(common::AddContext(status, absl::StrCat("layer of label ", layer->label())));
  }
  return proto;
}

absl::StatusOr<SemanticGrid> FromProto(const map::proto::SemanticGrid& proto, size_t num_labels) {
  RETURN_IF_ERROR(CheckResolution(proto.resolution_m()));
  SemanticGrid grid(proto.resolution_m());
  int64_t previous_label = -1;
  for (const map::proto::SemanticLayer& layer : proto.layers()) {
    absl::Status status = CheckLabel(layer.label(), previous_label, num_labels);
    if (status.ok()) status = ReadLayer(layer, &grid);
    RETURN_IF_ERROR(common::AddContext(status, absl::StrCat("layer of label ", layer.label())));
    previous_label = layer.label();
  }
  return grid;
}

}  // namespace cartographer::io
