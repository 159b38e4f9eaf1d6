// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0
'use strict';

// The controls beside the map: what of the drive is drawn, which labels, how opaque.

const PART_NAMES = {
  trajectory: 'Trajectory', odometry: 'Odometry alone', truth: 'Ground truth',
  closures: 'Loop closures',
};

function checkbox(name, checked, change, ...decoration) {
  const box = element('input', {type: 'checkbox', checked, onchange: () => change(box.checked)});
  return {box, label: element('label', {class: 'check'}, box, ...decoration, name)};
}

function colorLegend(coloring) {
  const [low, high] = colorRange(coloring.values);
  const bar = element('span', {class: 'ramp', style: `background: ${RAMP_GRADIENT}`});
  return element('div', {class: 'legend'}, formatNumber(low), bar,
                 `${formatNumber(high)} ${coloring.unit}`);
}

function coloringControl(drives) {
  const colorings = drives[0].data.colorings;
  const legend = element('div');
  const show = (index) => legend.replaceChildren(
      ...(colorings[index] ? [colorLegend(colorings[index])] : []));
  const select = element('select', {
    onchange: () => {
      drives.forEach((drive) => drive.colorBy(Number(select.value)));
      show(Number(select.value));
    },
  });
  colorings.forEach((coloring, index) => select.append(
      element('option', {value: index, textContent: `by ${coloring.name}`})));
  select.append(element('option', {value: -1, textContent: 'in one colour'}));
  show(0);
  return element('div', {class: 'coloring'},
                 element('label', {class: 'choice'}, 'Coloured', select), legend);
}

function driveControls(drives) {
  const group = element('fieldset', {}, element('legend', {textContent: 'Drive'}));
  for (const [part, name] of Object.entries(PART_NAMES)) {
    if (!drives.some((drive) => drive.has(part))) continue;
    const visible = drives[0].visible.get(part);
    const {label} = checkbox(
        name, visible, (on) => drives.forEach((drive) => drive.show(part, on)),
        element('span', {class: `line ${part}`}));
    group.append(label);
    if (part === 'trajectory' && drives[0].data.colorings.length > 0) {
      group.append(coloringControl(drives));
    }
  }
  return group;
}

function layerRow(layer, views) {
  const swatch = element('span', {class: 'swatch', style: `background: ${layer.color}`});
  const {box, label} = checkbox(
      layer.name, true, (on) => views.forEach((view) => view.show(layer.name, on)), swatch);
  const slider = element('input', {
    type: 'range', min: 0, max: 100, value: 100, 'aria-label': `Opacity of ${layer.name}`,
    oninput: () => views.forEach((view) => view.setOpacity(layer.name, slider.value / 100)),
  });
  return {box, row: element('div', {class: 'layer'}, label, slider)};
}

// The labels of all maps in the order of the first that has them, by group.
function layersByGroup(maps) {
  const groups = new Map();
  const names = new Set();
  for (const layer of maps.flatMap((map) => map.layers)) {
    if (names.has(layer.name)) continue;
    names.add(layer.name);
    if (!groups.has(layer.group)) groups.set(layer.group, []);
    groups.get(layer.group).push(layer);
  }
  return groups;
}

// One box for a whole group, on, off or between.
function groupControls(group, layers, views) {
  const rows = layers.map((layer) => layerRow(layer, views));
  const {box, label} = checkbox(group, true, (on) => {
    for (const row of rows) {
      if (row.box.checked !== on) row.box.click();
    }
  });
  const update = () => {
    const on = rows.filter((row) => row.box.checked).length;
    box.checked = on > 0;
    box.indeterminate = on > 0 && on < rows.length;
  };
  rows.forEach((row) => row.box.addEventListener('change', update));
  return element('fieldset', {}, element('legend', {}, label), ...rows.map(({row}) => row));
}

function buildPanel(panel, views, drives, maps) {
  panel.onsubmit = (event) => event.preventDefault();
  if (drives.some((drive) => drive.data.paths.length > 0)) panel.append(driveControls(drives));
  // The topmost layers come first, as they lie in the map.
  for (const [group, layers] of [...layersByGroup(maps)].reverse()) {
    panel.append(groupControls(group, [...layers].reverse(), views));
  }
}
