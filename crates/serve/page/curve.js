// Force against displacement: the curve, its limit points, Kendall's force, jumps, kept curves and the place that is dragged along it.

import { highest, inUnit, marks } from './results.js';
import { nameAxis } from './units.js';

const COLOUR = { stable: '#0072b2', unstable: '#c04f00', limit: '#1a1a1a', kendall: '#595959', jump: '#8f3f71', place: '#1a1a1a' };
/** Of kept curves. */
export const KEPT = ['#009e73', '#cc79a7', '#e69f00', '#56b4e9', '#6b5b95', '#7a7a00'];

/** Size of the text of the page, pixels: charts are drawn with it. */
export function textSize() {
  return parseFloat(getComputedStyle(document.documentElement).fontSize);
}

const line = (label, borderColor, more) => ({ label, data: [], borderColor, backgroundColor: borderColor, showLine: true, pointStyle: 'line', pointRadius: 0, pointHitRadius: 0, ...more });
const points = (label, colour, more) => ({ label, data: [], borderColor: colour, backgroundColor: colour, showLine: false, pointRadius: 5, ...more });

/** Puts the text of the page, its size and its colour, into the charts that are drawn from now on. */
export function takeText() {
  Chart.defaults.color = COLOUR.limit;
  Chart.defaults.font.size = textSize() * 0.85;
}

/** The labels of a legend; lines in it are dashed as they are in the chart. */
export function dashedLabels(chart) {
  const dash = ({ pointStyle, borderDash }) => (pointStyle === 'line' && borderDash) || [];
  const labels = Chart.defaults.plugins.legend.labels.generateLabels(chart);
  return labels.map((label) => ({ ...label, lineDash: dash(chart.data.datasets[label.datasetIndex]) }));
}

/** The chart of the curve. `moved(index)` is called with the pose to which the place is dragged. */
export class CurveChart {
  constructor(canvas, moved) {
    this.canvas = canvas;
    this.moved = moved;
    this.poses = [];
    this.at = 0;
    this.own = {
      place: points('place', COLOUR.place, { pointRadius: 8, pointStyle: 'circle', borderWidth: 3, backgroundColor: '#ffffff', order: -2 }),
      limits: points('limit points', COLOUR.limit, { pointStyle: 'rectRot', pointRadius: 6, order: -1 }),
      jumps: line('jumps of a test', COLOUR.jump, { borderDash: [2, 4], borderWidth: 2, pointRadius: [], order: 2 }),
      stable: line('stable', COLOUR.stable, { borderWidth: 3, order: 1 }),
      unstable: line('unstable under displacement control', COLOUR.unstable, { borderWidth: 3, borderDash: [8, 5], order: 1 }),
      equilibria: line('equilibria', COLOUR.limit, { borderWidth: 1.5, borderDash: [6, 4], order: 2 }),
      kendall: line('Kendall’s force', COLOUR.kendall, { borderWidth: 1.5, borderDash: [12, 4, 2, 4], order: 3 }),
    };
    // what is not there is not explained
    const isNamed = ({ text, datasetIndex }, { datasets }) => text !== 'place' && datasets[datasetIndex].data.length > 0;
    takeText();
    this.chart = new Chart(canvas, {
      type: 'scatter',
      data: { datasets: Object.values(this.own) },
      options: {
        animation: false, maintainAspectRatio: false,
        scales: {
          x: { title: { display: true, text: 'displacement u (nm)' } },
          y: { title: { display: true, text: 'force P (nN)' } },
        },
        plugins: {
          legend: { position: 'bottom', labels: { usePointStyle: true, pointStyleWidth: 30, generateLabels: dashedLabels, filter: isNamed } },
          tooltip: { filter: ({ dataset }) => dataset === this.own.limits, callbacks: { label: (item) => item.raw.text } },
        },
      },
    });
    this.listen();
  }

  resize() {
    takeText();
    this.chart.update('none');
    this.chart.resize();
  }

  /** The curve of a run. */
  show({ summary, curve, poses }, units) {
    const { displacement_nm: u, force_nN: p, unstable } = curve;
    const part = (wanted) => u.map((x, k) => {
      // neighbours share their end points
      const is = unstable[k] === wanted || (k > 0 && unstable[k - 1] === wanted);
      return { x, y: is ? p[k] : NaN };
    });
    this.own.stable.data = part(false);
    this.own.unstable.data = unstable.includes(true) ? part(true) : [];
    this.own.limits.label = summary.limit_points ? 'limit points' : 'results';
    this.own.limits.data = marks(summary, units);
    const slow = curve.equilibria;
    this.own.equilibria.data = slow ? slow.displacement_nm.map((x, k) => ({ x, y: slow.force_nN[k] })) : [];
    this.own.stable.label = slow ? 'at the rate' : 'stable';
    const kendall = summary.derived?.kendall_force_nN ?? null;
    const most = u.reduce((a, b) => Math.max(a, b), 0);
    const largest = p.reduce((a, b) => Math.max(a, b), 0);
    // one far above the curve would flatten it; the table has it
    const fits = kendall !== null && kendall < 1.5 * largest;
    this.own.kendall.data = fits ? [{ x: 0, y: kendall }, { x: most, y: kendall }] : [];
    this.own.jumps.data = [];
    this.poses = poses.along;
    this.curve = curve;
    const { x, y } = this.chart.options.scales;
    nameAxis(x, 'displacement u', units.u);
    nameAxis(y, 'force P', units.p);
    this.canvas.setAttribute('aria-label', this.words(summary, u, p, units));
    this.chart.update('none');
  }

  /** The jumps of a displacement-controlled test from the computed path; a test may go on behind its end. */
  showJumps(observed) {
    const radius = [];
    const { displacement_nm: u } = this.curve;
    const farthest = u.reduce((a, b) => Math.max(a, b), 0);
    this.own.jumps.data = (observed?.jumps ?? []).filter(({ way, before }) => way === 'retreat' && before.displacement_nm <= farthest).flatMap(({ before, after }) => {
      radius.push(0, 7, 0);
      return [{ x: before.displacement_nm, y: before.force_nN }, { x: after.displacement_nm, y: after.force_nN }, { x: NaN, y: NaN }];
    });
    this.own.jumps.pointRadius = radius;
    this.own.jumps.pointStyle = this.own.jumps.data.length > 0 ? 'triangle' : 'line';
    this.own.jumps.rotation = 180;
    this.chart.update('none');
  }

  /** Curves that are kept: label, colour, points, and whether each is unstable. */
  showKept(kept) {
    const dash = (unstable) => ({ p1DataIndex: index }) => (unstable[index] ? [8, 5] : undefined);
    const one = ({ label, colour, data, unstable }) => line(label, colour, { data, borderWidth: 2, order: 4, segment: { borderDash: dash(unstable) } });
    this.chart.data.datasets = [...Object.values(this.own), ...kept.map(one)];
    this.chart.update('none');
  }

  /** Moves the place to a pose. */
  move(index) {
    this.at = index;
    const pose = this.poses[index];
    this.own.place.data = pose ? [{ x: pose.displacement_nm, y: pose.force_nN }] : [];
    this.own.place.borderColor = pose?.unstable ? COLOUR.unstable : COLOUR.stable;
    this.chart.update('none');
  }

  /** The curve in words. */
  words(summary, u, p, units) {
    const last = u.length - 1;
    const length = (number, digits) => `${inUnit(number, units.u, digits)} ${units.u.name}`;
    const force = (number, digits) => `${inUnit(number, units.p, digits)} ${units.p.name}`;
    const peak = highest(summary);
    const largest = peak ? `, largest force ${force(peak.force_nN, 4)} at u = ${length(peak.displacement_nm, 4)}` : '';
    const limits = summary.limit_points ? `; ${summary.limit_points.length} limit points` : '';
    return `Force against displacement: from u = ${length(u[0], 3)}${largest}, to u = ${length(u[last], 3)}, P = ${force(p[last], 3)}${limits}. ` +
      'The slider below moves along it.';
  }

  listen() {
    let drags = false;
    const near = (event, everywhere) => {
      const { x, y } = this.chart.scales;
      const box = this.canvas.getBoundingClientRect();
      const [left, top] = [event.clientX - box.left, event.clientY - box.top];
      // where the curve passes near itself a drag stays on its part
      const window = everywhere ? Infinity : Math.max(8, this.poses.length / 6);
      let [best, least] = [this.at, Infinity];
      this.poses.forEach((pose, index) => {
        if (Math.abs(index - this.at) > window) return;
        const away = Math.hypot(x.getPixelForValue(pose.displacement_nm) - left, y.getPixelForValue(pose.force_nN) - top);
        if (away < least) [best, least] = [index, away];
      });
      return best;
    };
    this.canvas.addEventListener('pointerdown', (event) => {
      drags = true;
      this.canvas.setPointerCapture(event.pointerId);
      this.moved(near(event, true));
    });
    this.canvas.addEventListener('pointermove', (event) => { if (drags) this.moved(near(event, false)); });
    for (const end of ['pointerup', 'pointercancel']) this.canvas.addEventListener(end, () => { drags = false; });
  }
}
