// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0
'use strict';

// Asks the run every second how far it is, and shows it.

(() => {
  const POLL_MS = 1000;
  const LOST_AFTER = 3;
  const viewer = Math.random().toString(36).slice(2);
  const $ = (id) => document.getElementById(id);

  let view = null;      // the map, once there is a picture
  let drive = null;
  let picture = null;
  let version = 0;
  let touched = false;  // whoever moved the map keeps it where it is
  let failures = 0;

  function minutes(seconds) {
    const whole = Math.ceil(seconds);
    const pad = (number) => String(number).padStart(2, '0');
    const hours = Math.floor(whole / 3600);
    const rest = `${pad(Math.floor(whole / 60) % 60)}:${pad(whole % 60)}`;
    return hours > 0 ? `${hours}:${rest}` : rest.replace(/^0/, '');
  }

  function drivenMetres({x, y}) {
    let sum = 0;
    for (let i = 1; i < x.length; ++i) sum += Math.hypot(x[i] - x[i - 1], y[i] - y[i - 1]);
    return sum;
  }

  function figure(name, value, unit, note) {
    return element('div', {class: 'figure'}, element('dt', {textContent: name}),
                   element('dd', {}, element('b', {textContent: value}),
                           element('span', {class: 'unit', textContent: unit}),
                           element('small', {textContent: note})));
  }

  function showFigures(run, phase) {
    const rate = run.elapsed_s > 0 ? run.done / run.elapsed_s : 0;
    const left = rate > 0 ? (run.total - run.done) / rate : NaN;
    const driven = drivenMetres(run.path);
    const figures = [
      figure('Scans', run.done, `of ${run.total}`, `${formatNumber(100 * run.done / run.total)} %`),
      figure('Speed', rate.toFixed(1), 'scans/s', `${minutes(run.elapsed_s)} so far`),
      figure('Time left', phase === 'driving' && left >= 0 ? minutes(left) : '–', '', 'at this speed'),
      figure('Driven', driven >= 1000 ? (driven / 1000).toFixed(2) : driven.toFixed(0),
             driven >= 1000 ? 'km' : 'm', `${run.nodes} nodes, ${run.submaps} submaps finished`),
      figure('Loop closures', run.closures.length, '', `of ${run.candidates} candidates`),
      figure('Memory', run.memory_mib.toFixed(0), 'MiB', 'at the moment'),
    ];
    if (run.error_m !== null) {
      figures.push(figure('Off by', run.error_m.toFixed(2), 'm', 'the odometry, from ground truth'));
    }
    $('figures').replaceChildren(...figures);
  }

  function showStages(run) {
    const whole = run.stages.filter(({name}) => !name.includes('/'))
        .reduce((sum, stage) => sum + stage.total_s, 0) || 1;
    $('stages').replaceChildren(...run.stages.map((stage) => {
      const [parent, part] = stage.name.split('/');
      const share = (100 * stage.total_s / whole).toFixed(0);
      return element('tr', {},
          element('td', {class: part ? 'part' : '', textContent: (part || parent).replace(/_/g, ' ')}),
          element('td', {textContent: `${formatNumber(stage.mean_ms)} ms`}),
          element('td', {}, element('span', {class: 'share', style: `--part: ${share}%`,
                                             title: `${share} %`})));
    }));
    $('outcomes').replaceChildren(...Object.entries(run.outcomes).map(([word, count]) => element(
        'tr', {}, element('td', {textContent: word.replace(/_/g, ' ')}),
        element('td', {textContent: count}))));
  }

  function openMap(frame) {
    view = createMapView($('map'), {frame, halvings: 6, tile_side: 512, layers: []});
    drive = new DriveView(view.map, {
      frame, paths: [], colorings: [], closure_facts: [], closures: [], rejected_facts: [], rejected: [],
    });
    picture = L.imageOverlay('data:,', boundsOf(frame)).addTo(view.map);
    for (const event of ['mousedown', 'wheel', 'touchstart', 'keydown']) {
      $('map').addEventListener(event, () => { touched = true; }, {passive: true});
    }
  }

  function showMap(run, frame) {
    if (frame === null) return;
    if (view === null) openMap(frame);
    if (frame.version !== version) {
      version = frame.version;
      picture.setUrl(`/map.png?version=${version}`);
      picture.setBounds(boundsOf(frame));
      view.map.setMaxBounds(boundsOf(frame).pad(0.6));
    }
    drive.data.paths = [{name: 'trajectory', role: 'trajectory', ...run.path}];
    drive.data.closures = run.closures.map(
        ([x, y, u, v]) => ({node: [x, y], submap: [u, v], right: null, facts: []}));
    drive.draw();
    const nearby = L.latLngBounds(run.path.x.map((x, i) => [run.path.y[i], x]));
    if (!touched && nearby.isValid()) {
      const around = nearby.extend([nearby.getSouth() - 50, nearby.getWest() - 50])
          .extend([nearby.getNorth() + 50, nearby.getEast() + 50]);
      view.map.fitBounds(around, {animate: false});
    }
  }

  function statusText(phase, run) {
    if (phase === 'concluding') return 'All scans are in: last loop closures, then the files.';
    if (phase === 'done') return 'The run has ended.';
    if (phase === 'stopped') return 'The run was stopped; its files are whole for the scans so far.';
    return run === null ? 'Waiting for the first scan.' : `Scan ${run.done} of ${run.total}`;
  }

  function show({phase, snapshot, picture: frame}) {
    $('status').textContent = statusText(phase, snapshot);
    if (snapshot === null) return;
    document.title = `${Math.floor(100 * snapshot.done / snapshot.total)} % · a run, live`;
    $('progress').value = snapshot.done / snapshot.total;
    showFigures(snapshot, phase);
    showStages(snapshot);
    showMap(snapshot, frame);
  }

  async function fetchReport() {
    const answer = await fetch(`/report.html?viewer=${viewer}`);
    if (!answer.ok) throw new Error('no report');
    // The program may be gone when somebody wants to see it.
    const report = URL.createObjectURL(await answer.blob());
    $('open-report').href = report;
    $('save-report').href = report;
    document.title = 'The run has ended';
    $('title').textContent = 'A run';
    $('end').hidden = false;
  }

  async function look() {
    try {
      const state = await (await fetch(`/state.json?viewer=${viewer}`)).json();
      failures = 0;
      show(state);
      if (state.phase === 'done' || state.phase === 'stopped') return void await fetchReport();
    } catch (error) {
      if (!(error instanceof TypeError)) throw error;
      if (++failures >= LOST_AFTER) {
        $('status').textContent = 'The run does not answer any more: it has ended, or was ended.';
        return;
      }
    }
    setTimeout(look, POLL_MS);
  }

  look();
})();
