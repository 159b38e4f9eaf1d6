// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0
'use strict';

// The table of loop closures; its buttons show them on the map.

const CLOSURES_AT_FIRST = 8;

function closureRow(data, index, drive, stage) {
  const closure = data.closures[index];
  const button = element('button', {
    type: 'button', textContent: 'Show', 'aria-label': `Show loop closure ${index + 1} on the map`,
    onclick: () => {
      stage.scrollIntoView({block: 'nearest'});
      drive.select(index);
    },
  });
  const row = element('tr', {}, ...closure.facts.map(
      (fact) => element('td', {textContent: fact})), element('td', {}, button));
  if (closure.right === false) row.classList.add('wrong');
  return row;
}

function buildClosures(container, data, drive, stage) {
  if (data.closures.length === 0) return;
  const rows = data.closures.map((_, index) => closureRow(data, index, drive, stage));
  const body = element('tbody', {}, ...rows.slice(0, CLOSURES_AT_FIRST));
  const heads = [...data.closure_facts, ''].map(
      (name) => element('th', {scope: 'col', textContent: name}));
  const section = element('section', {}, element('h2', {textContent: 'Loop closures'}),
      element('div', {class: 'scroll'}, element('table', {},
          element('thead', {}, element('tr', {}, ...heads)), body)));
  if (rows.length > CLOSURES_AT_FIRST) {
    const more = element('button', {
      type: 'button', textContent: `All ${rows.length}`,
      onclick: () => {
        body.append(...rows.slice(CLOSURES_AT_FIRST));
        rows[CLOSURES_AT_FIRST].querySelector('button').focus();
        more.remove();
      },
    });
    section.append(more);
  }
  container.append(section);
}
