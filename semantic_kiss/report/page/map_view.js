// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0
'use strict';

// A map's pictures in Leaflet. Coordinates are metres: [y, x] where Leaflet says latitude and
// longitude. At zoom 0 a pixel of the pictures is one of the screen; -1 shows them halved.

const MAX_ZOOM = 5;
// The group of layers that are no label's but the shadows of what the group of their name holds.
const SHADOWS = 'Shadows';

function layerKey(layer) {
  return `${layer.group}/${layer.name}`;
}

// Scales between powers of two are chosen such that tiles have whole pixels: no seams.
function scaleOf(zoom, tileSide) {
  const level = Math.round(zoom);
  return 2 ** level * Math.round(2 ** (zoom - level) * tileSide) / tileSide;
}

// What is dark on paper is light on a dark page.
function inkClass(layer) {
  return layer.group !== SHADOWS && luminance(layer.color) < 0.12 ? 'dark-ink' : '';
}

function crsOf(frame, tileSide) {
  const scale = 1 / frame.resolution;
  return L.extend({}, L.CRS.Simple, {
    scale: (zoom) => scaleOf(zoom, tileSide),
    transformation: new L.Transformation(scale, -frame.min_x * scale, -scale, frame.max_y * scale),
  });
}

function boundsOf(frame) {
  return L.latLngBounds([frame.max_y - frame.height * frame.resolution, frame.min_x],
                        [frame.max_y, frame.min_x + frame.width * frame.resolution]);
}

// The pictures of one label.
const LabelLayer = L.GridLayer.extend({
  initialize(tiles, options) {
    this.tiles = tiles;
    L.setOptions(this, options);
  },
  createTile(coords, done) {
    const source = this.tiles[`${-coords.z}/${coords.x}/${coords.y}`];
    const tile = document.createElement(source ? 'img' : 'div');
    if (source) {
      tile.alt = '';
      tile.onload = () => done(null, tile);
      tile.src = source;
    } else {
      setTimeout(() => done(null, tile));
    }
    return tile;
  },
});

function addLabelLayers(map, data) {
  const bounds = boundsOf(data.frame);
  const layers = new Map();
  data.layers.forEach((layer, index) => {
    const grid = new LabelLayer(layer.tiles, {
      bounds, tileSize: data.tile_side, zIndex: index + 1, keepBuffer: 1, noWrap: true,
      minZoom: -data.halvings - 4, maxZoom: MAX_ZOOM,
      minNativeZoom: -data.halvings, maxNativeZoom: 0,
      className: inkClass(layer),
    });
    grid.addTo(map);
    layers.set(layerKey(layer), grid);
  });
  return layers;
}

// Returns {map, layers by key, show(key, visible), setOpacity(key, share)}.
function createMapView(container, data) {
  const map = L.map(container, {
    crs: crsOf(data.frame, data.tile_side), attributionControl: false, preferCanvas: true, fadeAnimation: false,
    zoomAnimation: !window.matchMedia('(prefers-reduced-motion: reduce)').matches,
    zoomSnap: 0.25, zoomDelta: 1, wheelPxPerZoomLevel: 90,
    minZoom: -data.halvings - 2, maxZoom: MAX_ZOOM, renderer: L.canvas({padding: 0.3, tolerance: 6}),
    maxBounds: boundsOf(data.frame).pad(0.6),
  });
  const sharpen = () => container.classList.toggle('pixels', map.getZoom() > 0.5);
  map.on('zoomend', sharpen);
  map.fitBounds(boundsOf(data.frame), {padding: [8, 8]});
  L.control.scale({imperial: false, maxWidth: 140}).addTo(map);
  const layers = addLabelLayers(map, data);
  sharpen();
  return {
    map, layers,
    show(key, visible) {
      const layer = layers.get(key);
      if (layer) visible ? layer.addTo(map) : layer.remove();
    },
    setOpacity(key, share) {
      const layer = layers.get(key);
      if (layer) layer.setOpacity(share);
    },
  };
}

// Makes maps follow each other.
function moveTogether(views) {
  let leader = null;
  for (const view of views) {
    view.map.on('move', () => {
      if (leader !== null) return;
      leader = view;
      for (const other of views) {
        if (other !== view) {
          other.map.setView(view.map.getCenter(), view.map.getZoom(), {animate: false});
        }
      }
      leader = null;
    });
  }
}
