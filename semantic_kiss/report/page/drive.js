// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0
'use strict';

// What was driven, drawn on a map: paths, loop closures, start and end.

const NUM_COLORS = 32;

function latLngs(path) {
  return path.x.map((x, i) => [path.y[i], x]);
}

// The range that colours span: extremes alone do not stretch it.
function colorRange(values) {
  const sorted = values.filter((value) => value !== null).sort((a, b) => a - b);
  if (sorted.length === 0) return [0, 1];
  const at = (share) => sorted[Math.round(share * (sorted.length - 1))];
  const [low, high] = [at(0.01), at(0.99)];
  return high > low ? [low, high] : [low, low + 1];
}

// The path as lines of one colour each.
function coloredLines(points, values) {
  const [low, high] = colorRange(values);
  const bin = (i) => Math.round(
      Math.min(Math.max((values[i] - low) / (high - low), 0), 1) * (NUM_COLORS - 1));
  const lines = [];
  for (let i = 0; i + 1 < points.length;) {
    let end = i + 1;
    while (end + 1 < points.length && bin(end) === bin(i)) ++end;
    lines.push(L.polyline(points.slice(i, end + 1), {
      color: rampColor(bin(i) / (NUM_COLORS - 1)), weight: 3.5, interactive: false,
    }));
    i = end;
  }
  return lines;
}

const PATH_STYLES = {
  trajectory: {weight: 3, color: 'trajectory'},
  odometry: {weight: 2, color: 'odometry', dashArray: '7 5'},
  truth: {weight: 2, color: 'truth', dashArray: '1 5'},
  earlier: {weight: 2.5, color: 'earlier', opacity: 0.9},
};

function plainLine(points, role) {
  const style = PATH_STYLES[role];
  return L.polyline(points, {...style, color: themeColor(style.color), interactive: false});
}

function endMarks(points) {
  const ring = {radius: 6, weight: 3, color: themeColor('ink'), fillColor: themeColor('paper'),
                fillOpacity: 1};
  return [
    L.circleMarker(points[0], ring).bindTooltip('Start'),
    L.circleMarker(points[points.length - 1], {...ring, fillColor: themeColor('ink')})
        .bindTooltip('End'),
  ];
}

function closureFacts(names, closure) {
  const list = element('dl', {class: 'facts'});
  names.forEach((name, i) => list.append(
      element('dt', {textContent: name}), element('dd', {textContent: closure.facts[i]})));
  return list;
}

// Loop closures and what might have been one: a line from the scan to the submap.
const CLOSURE_STYLES = {
  closures: {facts: 'closure_facts', color: 'closure', line: {weight: 1.5, opacity: 0.6}, radius: 2},
  rejected: {facts: 'rejected_facts', color: 'rejected', radius: 3.5,
             line: {weight: 1.5, opacity: 0.8, dashArray: '2 4'}},
};

function closureLine(part, data, closure) {
  const style = CLOSURE_STYLES[part];
  const color = themeColor(closure.right === false ? 'wrong' : style.color);
  const ends = [closure.node, closure.submap].map(([x, y]) => [y, x]);
  const group = L.featureGroup([
    L.polyline(ends, {color, ...style.line}),
    L.circleMarker(ends[0], {radius: style.radius, weight: 0, fillColor: color, fillOpacity: 1}),
  ]);
  return group.bindPopup(() => closureFacts(data[style.facts], closure), {maxWidth: 260});
}

// Everything of a drive on one map. Parts: "trajectory", "odometry", "truth", "earlier" (by role),
// "closures", "rejected".
class DriveView {
  constructor(map, data) {
    this.map = map;
    this.data = data;
    this.visible = new Map([['trajectory', true], ['odometry', false], ['truth', false],
                            ['earlier', true], ['closures', true], ['rejected', false]]);
    this.onshow = [];  // called with (part, visible)
    this.coloring = data.colorings.length > 0 ? 0 : -1;
    this.group = L.layerGroup().addTo(map);
    this.lines = {closures: [], rejected: []};
    this.cursor = null;
    this.draw();
    darkTheme.addEventListener('change', () => this.draw());
  }

  has(part) {
    if (part in CLOSURE_STYLES) return this.data[part].length > 0;
    return this.data.paths.some((path) => path.role === part);
  }

  show(part, visible) {
    this.visible.set(part, visible);
    this.draw();
    this.onshow.forEach((tell) => tell(part, visible));
  }

  colorBy(index) {
    this.coloring = index;
    this.draw();
  }

  draw() {
    this.group.clearLayers();
    const add = (layer) => this.group.addLayer(layer);
    for (const role of ['earlier', 'truth', 'odometry']) {
      for (const path of this.data.paths) {
        if (path.role === role && this.visible.get(role)) add(plainLine(latLngs(path), role));
      }
    }
    if (this.visible.get('trajectory')) {
      this.data.paths.forEach((path, index) => {
        if (path.role === 'trajectory' && path.x.length > 0) this.drawTrajectory(path, index, add);
      });
    }
    for (const part of ['rejected', 'closures']) {
      this.lines[part] = this.data[part].map((closure) => closureLine(part, this.data, closure));
      if (this.visible.get(part)) this.lines[part].forEach(add);
    }
  }

  drawTrajectory(path, index, add) {
    const points = latLngs(path);
    add(L.polyline(points, {color: themeColor('casing'), weight: 6.5, opacity: 0.85,
                            interactive: false}));
    const coloring = index === 0 ? this.data.colorings[this.coloring] : undefined;
    const lines = coloring ? coloredLines(points, coloring.values)
                           : [plainLine(points, 'trajectory')];
    lines.forEach(add);
    endMarks(points).forEach(add);
  }

  // Opens what is known of a closure, or of a candidate that became none.
  select(part, index) {
    if (!this.visible.get(part)) this.show(part, true);
    const closure = this.lines[part][index];
    this.map.fitBounds(closure.getBounds().pad(1), {maxZoom: 1, animate: false});
    closure.openPopup();
  }

  // Marks a position of the first path; null: none.
  point(index) {
    if (this.cursor !== null) this.cursor.remove();
    this.cursor = null;
    const path = this.data.paths[0];
    if (index === null || !path || index >= path.x.length) return;
    this.cursor = L.circleMarker([path.y[index], path.x[index]], {
      radius: 7, weight: 3, color: themeColor('paper'), fillColor: themeColor('accent'),
      fillOpacity: 1, interactive: false,
    }).addTo(this.map);
  }

  // The position of the first path that is nearest to a place, within some pixels; else null.
  nearest(latLng) {
    const path = this.data.paths[0];
    if (!path) return null;
    let [best, index] = [Infinity, null];
    for (let i = 0; i < path.x.length; ++i) {
      const distance = (path.x[i] - latLng.lng) ** 2 + (path.y[i] - latLng.lat) ** 2;
      if (distance < best) [best, index] = [distance, i];
    }
    const reach = 18 * this.data.frame.resolution / this.map.getZoomScale(this.map.getZoom(), 0);
    return Math.sqrt(best) <= reach ? index : null;
  }
}
