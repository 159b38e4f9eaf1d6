// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0
'use strict';

// Charts as SVG, drawn anew whenever their place changes its width.

const CHART_HEIGHT = 224;
const ROW_HEIGHT = 24;
const MARGIN = {left: 46, right: 22, top: 24, bottom: 34};

function svg(tag, attributes = {}, ...children) {
  const result = document.createElementNS('http://www.w3.org/2000/svg', tag);
  for (const [name, value] of Object.entries(attributes)) result.setAttribute(name, value);
  result.append(...children);
  return result;
}

// Round numbers that divide [low, high] into about `count` parts.
function ticks(low, high, count) {
  const raw = (high - low) / count;
  const power = 10 ** Math.floor(Math.log10(raw));
  const step = [1, 2, 5, 10].map((factor) => factor * power).find((size) => size >= raw);
  const result = [];
  for (let i = Math.ceil(low / step); i * step <= high + step * 1e-9; ++i) result.push(i * step);
  return {values: result, digits: Math.max(0, -Math.floor(Math.log10(step) + 1e-9))};
}

function tickText(value, digits) {
  return value.toFixed(digits).replace('-', '\u2212');
}

function extent(values) {
  let [low, high] = [Infinity, -Infinity];
  for (const value of values) {
    if (value === null) continue;
    low = Math.min(low, value);
    high = Math.max(high, value);
  }
  return low <= high ? [low, high] : [0, 1];
}

// The area that data are drawn in, and where a value is.
function plotArea(width, height, [x0, x1], [y0, y1]) {
  const [left, right] = [MARGIN.left, width - MARGIN.right];
  const [top, bottom] = [MARGIN.top, height - MARGIN.bottom];
  return {
    left, right, top, bottom,
    x: (value) => left + (value - x0) / (x1 - x0) * (right - left),
    y: (value) => bottom - (value - y0) / (y1 - y0) * (bottom - top),
  };
}

function text(x, y, content, attributes = {}) {
  return svg('text', {x, y, ...attributes}, content);
}

function drawYAxis(root, area, [low, high], name) {
  const {values, digits} = ticks(low, high, 4);
  for (const value of values) {
    const y = area.y(value);
    root.append(svg('line', {x1: area.left, x2: area.right, y1: y, y2: y, class: 'grid'}),
                text(area.left - 7, y + 4, tickText(value, digits), {'text-anchor': 'end'}));
  }
  root.append(text(area.left, 12, name, {class: 'axis'}));
}

function drawXAxis(root, area, [low, high], name) {
  const {values, digits} = ticks(low, high, Math.max(2, (area.right - area.left) / 90));
  for (const value of values) {
    root.append(text(area.x(value), area.bottom + 16, tickText(value, digits),
                     {'text-anchor': 'middle'}));
  }
  root.append(text(area.right, area.bottom + 30, name, {'text-anchor': 'end', class: 'axis'}));
}

function padded([low, high], fromZero) {
  if (fromZero) low = Math.min(low, 0);
  const space = (high - low || 1) * 0.06;
  return [fromZero && low === 0 ? 0 : low - space, high + space];
}

function linePath(area, xs, ys) {
  let path = '';
  let pen = 'M';
  for (let i = 0; i < ys.length; ++i) {
    if (ys[i] === null) {
      pen = 'M';
      continue;
    }
    path += `${pen}${area.x(xs[i]).toFixed(1)} ${area.y(ys[i]).toFixed(1)}`;
    pen = 'L';
  }
  return path;
}

// The ones that matter most are drawn last, on top.
function drawLines(root, area, chart) {
  for (const series of [...chart.series].reverse()) {
    root.append(svg('path', {d: linePath(area, chart.x, series.values),
                             class: `series ${series.role}`}));
  }
}

function legend(chart) {
  if (chart.series.length < 2) return [];
  return [element('div', {class: 'keys'}, ...chart.series.map((series) => element(
      'span', {}, element('span', {class: `${chart.kind === 'line' ? 'line' : 'swatch'} ${series.role}`}),
      series.name)))];
}

function indexAt(xs, value) {
  let [low, high] = [0, xs.length - 1];
  while (low < high) {
    const middle = (low + high) >> 1;
    if (xs[middle] < value) low = middle + 1; else high = middle;
  }
  return low > 0 && value - xs[low - 1] < xs[low] - value ? low - 1 : low;
}

function lineChart(container, chart, width) {
  const xRange = extent(chart.x);
  if (xRange[0] === xRange[1]) xRange[1] += 1;
  const values = chart.series.flatMap((series) => series.values);
  const yRange = padded(extent(values), extent(values)[0] >= 0);
  const area = plotArea(width, CHART_HEIGHT, xRange, yRange);
  const root = svg('svg', {
    viewBox: `0 0 ${width} ${CHART_HEIGHT}`, role: 'img', tabindex: 0,
    'aria-label': `${chart.heading}: ${chart.y_name} over ${chart.x_name}. Arrow keys read values.`,
  });
  drawYAxis(root, area, yRange, chart.y_name);
  drawXAxis(root, area, xRange, chart.x_name);
  drawLines(root, area, chart);
  const hair = svg('line', {y1: area.top, y2: area.bottom, class: 'hair', visibility: 'hidden'});
  root.append(hair);
  const readout = element('output', {class: 'readout'});
  container.replaceChildren(...legend(chart), root, readout);
  return {
    root,
    indexAtPointer(event) {
      const box = root.getBoundingClientRect();
      const x = (event.clientX - box.left) / box.width * width;
      const share = (x - area.left) / (area.right - area.left);
      return indexAt(chart.x, xRange[0] + share * (xRange[1] - xRange[0]));
    },
    point(index) {
      hair.setAttribute('visibility', index === null ? 'hidden' : 'visible');
      readout.textContent = '\u00a0';
      if (index === null) return;
      const x = area.x(chart.x[index]);
      hair.setAttribute('x1', x);
      hair.setAttribute('x2', x);
      readout.textContent = [`${formatNumber(chart.x[index])} m`, ...chart.series.map(
          (series) => `${series.name} ${formatNumber(series.values[index])}`)].join('  ·  ');
    },
  };
}

function columnChart(container, chart, width) {
  const yRange = padded([0, extent(chart.series.flatMap((series) => series.values))[1]], true);
  const area = plotArea(width, CHART_HEIGHT, [0, chart.categories.length], yRange);
  const root = svg('svg', {viewBox: `0 0 ${width} ${CHART_HEIGHT}`, role: 'img',
                           'aria-label': `${chart.heading}: ${chart.y_name}`});
  drawYAxis(root, area, yRange, chart.y_name);
  const side = (area.x(1) - area.x(0)) * 0.7 / chart.series.length;
  chart.categories.forEach((category, i) => {
    root.append(text(area.x(i + 0.5), area.bottom + 16, category, {'text-anchor': 'middle'}));
    chart.series.forEach((series, k) => {
      const value = series.values[i];
      if (value === null) return;
      const bar = svg('rect', {
        x: area.x(i + 0.15) + k * side, y: area.y(value), width: Math.max(side - 2, 1),
        height: area.bottom - area.y(value), rx: 2, class: `bar ${series.role}`,
      }, svg('title', {}, `${series.name}, ${category}: ${formatNumber(value)}`));
      root.append(bar);
    });
  });
  root.append(text(area.right, area.bottom + 30, chart.x_name,
                   {'text-anchor': 'end', class: 'axis'}));
  container.replaceChildren(...legend(chart), root);
}

function rowChart(container, chart, width) {
  const [values] = chart.series.map((series) => series.values);
  const height = chart.categories.length * ROW_HEIGHT;
  const names = Math.min(170, width * 0.48);
  const most = extent(values)[1] || 1;
  const length = (value) => Math.max(value / most * (width - names - 70), 1);
  const root = svg('svg', {viewBox: `0 0 ${width} ${height}`, role: 'img',
                           'aria-label': `${chart.heading}: ${chart.y_name}`});
  chart.categories.forEach((category, i) => {
    const y = i * ROW_HEIGHT;
    root.append(text(names - 10, y + 16, category, {'text-anchor': 'end'}),
                svg('rect', {x: names, y: y + 5, width: length(values[i]), height: ROW_HEIGHT - 10,
                             rx: 2, class: `bar ${chart.series[0].role}`}),
                text(names + length(values[i]) + 7, y + 16,
                     `${formatNumber(values[i])} ${chart.y_name}`, {class: 'value'}));
  });
  container.replaceChildren(root);
}

// Draws a chart and keeps it fitting. `link` connects charts along the path with each other and
// with the map: link.point(index) is called for what the pointer or the arrow keys choose.
function buildChart(container, chart, link) {
  const draw = {line: lineChart, columns: columnChart, rows: rowChart}[chart.kind];
  let drawn = null;
  let chosen = null;
  const connect = () => {
    const choose = (index) => {
      chosen = index;
      chart.along_path ? link.point(index) : drawn.point(index);
    };
    drawn.root.addEventListener('pointermove', (event) => choose(drawn.indexAtPointer(event)));
    drawn.root.addEventListener('pointerleave', () => choose(null));
    drawn.root.addEventListener('blur', () => choose(null));
    drawn.root.addEventListener('keydown', (event) => {
      const step = {ArrowLeft: -1, ArrowRight: 1}[event.key];
      if (!step) return;
      event.preventDefault();
      const stride = Math.max(1, Math.round(chart.x.length / 100));
      const next = chosen === null ? 0 : chosen + step * stride;
      choose(Math.min(Math.max(next, 0), chart.x.length - 1));
    });
    drawn.point(null);
  };
  let width = 0;
  new ResizeObserver(() => {
    const now = Math.floor(container.clientWidth);
    if (now === width || now === 0) return;
    width = now;
    drawn = draw(container, chart, width);
    if (drawn) connect();
  }).observe(container);
  if (chart.along_path && chart.kind === 'line') {
    link.charts.push((index) => drawn && drawn.point(index));
  }
}
