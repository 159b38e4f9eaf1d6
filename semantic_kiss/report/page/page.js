// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0
'use strict';

// Puts the page together from its data.

(() => {
  const data = JSON.parse(document.getElementById('data').textContent);
  const stage = document.getElementById('stage');

  function addMap(mapData) {
    const canvas = element('div', {class: 'map', role: 'application',
                                   'aria-label': `Map ${mapData.caption}`});
    const figure = element('figure', {}, canvas);
    if (data.maps.length > 1) {
      figure.prepend(element('figcaption', {textContent: mapData.caption}));
    }
    stage.append(figure);
    return canvas;
  }

  const canvases = data.maps.map(addMap);
  const views = data.maps.map((mapData, i) => createMapView(canvases[i], mapData));
  const drives = data.maps.map((mapData, i) => new DriveView(views[i].map, mapData));
  moveTogether(views);

  const link = {
    charts: [],
    point(index) {
      this.charts.forEach((point) => point(index));
      if (drives.length > 0) drives[0].point(index);
    },
  };
  if (views.length > 0) {
    buildPanel(document.getElementById('panel'), views, drives, data.maps);
    buildClosures(document.getElementById('closures'), data.maps[0], drives[0], stage);
    if (data.charts.some((chart) => chart.along_path)) {
      views[0].map.on('mousemove', (event) => link.point(drives[0].nearest(event.latlng)));
      views[0].map.on('mouseout', () => link.point(null));
    }
  } else {
    document.querySelector('.map-section').remove();
  }
  data.charts.forEach(
      (chart, i) => buildChart(document.getElementById(`chart-${i}`), chart, link));
})();
