// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0
'use strict';

// The tables of loop closures and of what might have been one; their buttons show them on the map.

const ROWS_AT_FIRST = 8;

const CLOSURE_TABLES = [
  {part: 'closures', facts: 'closure_facts', heading: 'Loop closures', one: 'loop closure', note: ''},
  {part: 'rejected', facts: 'rejected_facts', heading: 'Rejected closures', one: 'rejected closure',
   note: 'For each scan, the rejected candidate that passed the most checks, and how many of the ' +
         'scan\'s other candidates were accepted.'},
];

function closureRow(table, data, index, drive, stage) {
  const closure = data[table.part][index];
  const button = element('button', {
    type: 'button', textContent: 'Show', 'aria-label': `Show ${table.one} ${index + 1} on the map`,
    onclick: () => {
      stage.scrollIntoView({block: 'nearest'});
      drive.select(table.part, index);
    },
  });
  const row = element('tr', {}, ...closure.facts.map(
      (fact) => element('td', {textContent: fact})), element('td', {}, button));
  if (closure.right === false) row.classList.add('wrong');
  return row;
}

function closureTable(table, data, drive, stage) {
  const rows = data[table.part].map((_, index) => closureRow(table, data, index, drive, stage));
  const body = element('tbody', {}, ...rows.slice(0, ROWS_AT_FIRST));
  const heads = [...data[table.facts], ''].map(
      (name) => element('th', {scope: 'col', textContent: name}));
  const section = element('section', {}, element('h2', {textContent: table.heading}),
      ...(table.note ? [element('p', {class: 'note', textContent: table.note})] : []),
      element('div', {class: 'scroll'}, element('table', {},
          element('thead', {}, element('tr', {}, ...heads)), body)));
  if (rows.length > ROWS_AT_FIRST) {
    const more = element('button', {
      type: 'button', textContent: `All ${rows.length}`,
      onclick: () => {
        body.append(...rows.slice(ROWS_AT_FIRST));
        rows[ROWS_AT_FIRST].querySelector('button').focus();
        more.remove();
      },
    });
    section.append(more);
  }
  return section;
}

function buildClosures(container, data, drive, stage) {
  container.append(...CLOSURE_TABLES.filter(({part}) => data[part].length > 0).map(
      (table) => closureTable(table, data, drive, stage)));
}
