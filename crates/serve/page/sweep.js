// The largest force against the bending stiffness: filled in, value by value, while nothing else is asked.

import { ask } from './server.js';
import { shown } from './results.js';
import { dashedLabels, fitAxis, takeText } from './curve.js';

/** Factors of the bending stiffness, from here to its inverse. */
const LEAST = 1e-4;
const POINTS = 33;

const series = (label, colour, style, more) => ({ label, data: [], borderColor: colour, backgroundColor: colour, pointStyle: style, pointRadius: 4, showLine: true, borderWidth: 1.5, ...more });

/** The chart of the sweep. */
export class Sweep {
  constructor(canvas, text) {
    Object.assign(this, { canvas, text, abort: null });
    this.series = {
      peak: series('peak', '#0072b2', 'circle'),
      plateau: series('plateau', '#009e73', 'rect'),
      kendall: series('Kendall’s force', '#595959', 'line', { pointRadius: 0, borderDash: [12, 4, 2, 4] }),
      here: series('this scene', '#1a1a1a', 'circle', { pointRadius: 8, borderWidth: 3, backgroundColor: '#ffffff', order: -1, showLine: false }),
    };
    this.chart = new Chart(canvas, {
      type: 'scatter',
      data: { datasets: Object.values(this.series) },
      options: {
        animation: false, maintainAspectRatio: false,
        scales: {
          x: { type: 'logarithmic', min: LEAST, max: 1 / LEAST, title: { display: true, text: 'factor of the bending stiffness EI' }, ticks: { callback: (value) => (Number.isInteger(Math.log10(value)) ? value.toExponential(0) : '') } },
          y: { title: { display: true, text: 'force P (nN)' }, beginAtZero: true },
        },
        plugins: { legend: { position: 'bottom', labels: { usePointStyle: true, pointStyleWidth: 24, generateLabels: dashedLabels } } },
      },
    });
  }

  resize() {
    takeText();
    this.chart.update('none');
    this.chart.resize();
  }

  /** Ends what is being computed. */
  stop() {
    this.abort?.abort();
    this.abort = null;
  }

  /** Computes the values one after the other, those next to the scene's own first. `key` is that of the factor, `now` its value. */
  async fill(scene, key, now, summary) {
    this.stop();
    const abort = new AbortController();
    this.abort = abort;
    const { peak, plateau, kendall, here } = this.series;
    peak.data = [];
    plateau.data = [];
    const force = summary.derived.kendall_force_nN;
    kendall.data = force === null ? [] : [{ x: LEAST, y: force }, { x: 1 / LEAST, y: force }];
    const own = summary.peak ?? summary.largest_computed_force;
    here.data = own ? [{ x: now, y: own.force_nN }] : [];
    fitAxis(this.chart.options.scales.y, 'force P', 'nN', own?.force_nN ?? force ?? 0);
    const factors = Array.from({ length: POINTS }, (_, k) => LEAST ** (1 - (2 * k) / (POINTS - 1)));
    factors.sort((a, b) => Math.abs(Math.log(a / now)) - Math.abs(Math.log(b / now)));
    let failed = 0;
    for (const factor of factors) {
      try {
        const text = String(Number(factor.toPrecision(6)));
        const { summary } = await ask('api/peel', { ...scene, set: [...scene.set, [key, text]] }, abort.signal);
        add(peak.data, factor, summary.peak);
        add(plateau.data, factor, summary.plateau);
      } catch (error) {
        if (error.name === 'AbortError' || abort.signal.aborted) return;
        failed += 1;
      }
      this.chart.update('none');
    }
    this.tell(failed);
  }

  tell(failed) {
    const best = this.series.peak.data.reduce((a, b) => (a && a.y >= b.y ? a : b), null);
    const largest = best ? `The largest of these peaks is ${shown(best.y, 4)} nN, at ${shown(best.x, 3)} times the stiffness.` : 'No path has a peak.';
    this.text.textContent = `${POINTS} runs. ${largest}${failed ? ` ${failed} runs were refused.` : ''}`;
    this.canvas.setAttribute('aria-label', `Force against bending stiffness. ${this.text.textContent}`);
  }
}

function add(data, x, at) {
  if (!at) return;
  const place = data.findIndex((point) => point.x > x);
  data.splice(place < 0 ? data.length : place, 0, { x, y: at.force_nN });
}
