// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0
'use strict';

// Colours, by role and by value. Those of the theme stand in page.css.

const darkTheme = window.matchMedia('(prefers-color-scheme: dark)');

function themeColor(name) {
  return getComputedStyle(document.documentElement).getPropertyValue(`--${name}`).trim();
}

// From good to bad; dark to bright would vanish in one of the themes.
const RAMP = [[34, 128, 196], [44, 178, 170], [150, 205, 75], [250, 200, 40], [240, 110, 40],
              [205, 30, 60]];

// The colour of a share in [0, 1] of the ramp.
function rampColor(share) {
  const position = Math.min(Math.max(share, 0), 1) * (RAMP.length - 1);
  const index = Math.min(Math.floor(position), RAMP.length - 2);
  const mix = RAMP[index].map(
      (channel, i) => Math.round(channel + (RAMP[index + 1][i] - channel) * (position - index)));
  return `rgb(${mix.join(',')})`;
}

const RAMP_GRADIENT = `linear-gradient(to right, ${
    RAMP.map((_, i) => rampColor(i / (RAMP.length - 1))).join(', ')})`;

// How bright "#rrggbb" seems, in [0, 1].
function luminance(hex) {
  const [r, g, b] = [1, 3, 5].map((i) => parseInt(hex.slice(i, i + 2), 16) / 255);
  return 0.21 * r + 0.72 * g + 0.07 * b;
}

// Numbers for people: three digits that count, no more.
function formatNumber(value) {
  if (value === null || !Number.isFinite(value)) return '–';
  const size = Math.abs(value);
  const digits = size >= 100 ? 0 : size >= 10 ? 1 : size >= 1 ? 2 : 3;
  return value.toFixed(digits).replace('-', '\u2212');
}

// An element with attributes and children; `text` and handlers (`onclick`) included.
function element(tag, attributes = {}, ...children) {
  const result = document.createElement(tag);
  for (const [name, value] of Object.entries(attributes)) {
    if (name.startsWith('on') || name === 'checked' || name === 'textContent') {
      result[name] = value;
    } else {
      result.setAttribute(name, value);
    }
  }
  result.append(...children);
  return result;
}
