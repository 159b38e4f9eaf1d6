// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0
'use strict';

// The controls beside the map: what of the drive is drawn, which labels, how opaque.

const PART_NAMES = {
  trajectory: 'Trajectory', odometry: 'Odometry alone', truth: 'Ground truth',
  earlier: 'Earlier drives',
  closures: 'Loop closures', rejected: 'Rejected closures',
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
    const {box, label} = checkbox(
        name, visible, (on) => drives.forEach((drive) => drive.show(part, on)),
        element('span', {class: `line ${part}`}));
    drives.forEach((drive) => drive.onshow.push((shown, on) => {
      if (shown === part) box.checked = on;
    }));
    group.append(label);
    if (part === 'trajectory' && drives[0].data.colorings.length > 0) {
      group.append(coloringControl(drives));
    }
  }
  return group;
}

function layerRow(layer, views) {
  const key = layerKey(layer);
  const swatch = element('span', {class: `swatch ${inkClass(layer)}`, style: `background: ${layer.color}`});
  const {box, label} = checkbox(
      layer.name, true, (on) => views.forEach((view) => view.show(key, on)), swatch);
  const slider = element('input', {
    type: 'range', min: 0, max: 100, value: 100, 'aria-label': `Opacity of ${layer.name}`,
    oninput: () => views.forEach((view) => view.setOpacity(key, slider.value / 100)),
  });
  return {key, box, row: element('div', {class: 'layer'}, label, slider)};
}

// The labels of all maps in the order of the first that has them, by group.
function layersByGroup(maps) {
  const groups = new Map();
  const keys = new Set();
  for (const layer of maps.flatMap((map) => map.layers)) {
    if (keys.has(layerKey(layer))) continue;
    keys.add(layerKey(layer));
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
  const fieldset = element('fieldset', {}, element('legend', {}, label),
                           ...rows.map(({row}) => row));
  return {group, rows, fieldset};
}

// Shadows go with what casts them: one is drawn while its box is checked and so is any in its group.
function tieShadows(groups, views) {
  const shadows = groups.find(({group}) => group === SHADOWS);
  if (!shadows) return;
  for (const {key, box} of shadows.rows) {
    const casting = groups.find(({group}) => key === layerKey({group: SHADOWS, name: group}));
    if (!casting) continue;
    const update = () => {
      const visible = box.checked && casting.rows.some((row) => row.box.checked);
      views.forEach((view) => view.show(key, visible));
    };
    [...casting.rows.map((row) => row.box), box].forEach(
        (each) => each.addEventListener('change', update));
  }
}

function buildPanel(panel, views, drives, maps) {
  panel.onsubmit = (event) => event.preventDefault();
  if (drives.some((drive) => drive.data.paths.length > 0)) panel.append(driveControls(drives));
  // The topmost layers come first, as they lie in the map.
  const groups = [...layersByGroup(maps)].reverse().map(
      ([group, layers]) => groupControls(group, [...layers].reverse(), views));
  groups.forEach(({fieldset}) => panel.append(fieldset));
  tieShadows(groups, views);
}
