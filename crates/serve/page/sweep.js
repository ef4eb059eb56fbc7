// The largest force against a key of the scene: filled in, value by value, while nothing else is asked.

import { ask } from './server.js';
import { highest, shown } from './results.js';
import { dashedLabels, takeText } from './curve.js';
import { nameAxis, unitOf } from './units.js';

const POINTS = 33;
/** A range is gone over by equal factors where its end is so many times its beginning. */
const WIDE = 5;
/** Where a key has no slider: from its value over this to its value times this. */
const AROUND = 4;

const series = (label, colour, style, more) => ({ label, data: [], borderColor: colour, backgroundColor: colour, pointStyle: style, pointRadius: 4, showLine: true, borderWidth: 1.5, ...more });

/** A number as a scene has it. */
const written = (number) => String(Number(number.toPrecision(6)));

/** The chart of the sweep. `fields` are the key, the ends of its values and their unit; `changed()` is called when one of them is. */
export class Sweep {
  constructor(canvas, text, fields, changed) {
    Object.assign(this, { canvas, text, fields, abort: null, controls: [] });
    this.series = {
      peak: series('peak', '#0072b2', 'circle'),
      plateau: series('plateau', '#009e73', 'rect'),
      equilibria: series('peak of the equilibria', '#6b5b95', 'triangle'),
      kendall: series('Kendall’s force', '#595959', 'line', { pointRadius: 0, borderDash: [12, 4, 2, 4] }),
      here: series('this scene', '#1a1a1a', 'circle', { pointRadius: 8, borderWidth: 3, backgroundColor: '#ffffff', order: -1, showLine: false }),
    };
    const isShown = ({ datasetIndex }, { datasets }) => datasets[datasetIndex].data.length > 0;
    this.chart = new Chart(canvas, {
      type: 'scatter',
      data: { datasets: Object.values(this.series) },
      options: {
        animation: false, maintainAspectRatio: false,
        scales: {
          x: { type: 'linear', title: { display: true, text: '' } },
          y: { title: { display: true, text: 'force P (nN)' }, beginAtZero: true, ticks: {} },
        },
        plugins: { legend: { position: 'bottom', labels: { usePointStyle: true, pointStyleWidth: 24, generateLabels: dashedLabels, filter: isShown } } },
      },
    });
    fields.key.addEventListener('change', () => {
      this.edited = false;
      this.fillFields();
      changed();
    });
    for (const field of [fields.from, fields.to]) {
      field.addEventListener('change', () => {
        this.edited = true;
        changed();
      });
    }
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

  /** Offers the keys of a scene that are numbers; the one that was chosen stays. */
  offer(controls) {
    this.controls = controls.filter(({ kind }) => kind === 'number');
    const { key } = this.fields;
    const before = key.value;
    key.replaceChildren(...this.controls.map(({ key, about }) => new Option(`${about} (${key})`, key)));
    const has = (wanted) => this.controls.some(({ key }) => key === wanted);
    const usual = this.controls.findLast(({ key, value }) => key.endsWith('.bending_stiffness_factor') && value !== null);
    const chosen = has(before) ? before : (usual ?? this.controls[0])?.key ?? '';
    if (chosen !== before) this.edited = false;
    key.value = chosen;
    this.fillFields();
  }

  /** The key that is chosen. */
  chosen() {
    return this.controls.find(({ key }) => key === this.fields.key.value);
  }

  /** The range of the chosen key, where nobody has given another one. */
  fillFields() {
    const control = this.chosen();
    this.fields.unit.textContent = control?.unit ?? '';
    if (!control || this.edited) return;
    const { slider, value } = control;
    const [from, to] = slider ? [slider.low, slider.high] : value > 0 ? [value / AROUND, value * AROUND] : ['', ''];
    this.fields.from.value = from === '' ? '' : written(from);
    this.fields.to.value = to === '' ? '' : written(to);
  }

  /** The values to compute, ascending; none where the ends are no range. */
  values() {
    const ends = [this.fields.from.value, this.fields.to.value].map((text) => (text.trim() === '' ? NaN : Number(text)));
    const [from, to] = ends.sort((a, b) => a - b);
    if (!(from < to)) return { values: [], logarithmic: false };
    const logarithmic = from > 0 && to / from >= WIDE;
    const at = (share) => (logarithmic ? from * (to / from) ** share : from + (to - from) * share);
    const values = Array.from({ length: POINTS }, (_, k) => at(k / (POINTS - 1)));
    const whole = this.chosen().whole ? values.map(Math.round) : values;
    return { values: [...new Set(whole.map((value) => Number(written(value))))], logarithmic };
  }

  /** Computes the values one after the other, those next to the scene's own first. */
  async fill(scene, summary) {
    this.stop();
    const control = this.chosen();
    const abort = new AbortController();
    this.abort = abort;
    for (const one of Object.values(this.series)) one.data = [];
    const { values, logarithmic } = control ? this.values() : { values: [] };
    if (values.length === 0) {
      this.text.textContent = 'Give two numbers, from and to.';
      return this.chart.update('none');
    }
    const { key, about, unit, value: now } = control;
    this.text.textContent = '';
    const own = highest(summary);
    if (own && now !== null) this.series.here.data = [{ x: now, y: own.force_nN }];
    const { scales } = this.chart.options;
    const decade = (value) => {
      if (!Number.isInteger(Math.round(1e6 * Math.log10(value)) / 1e6)) return '';
      return value >= 1e-3 && value <= 1e4 ? written(value) : value.toExponential(0);
    };
    scales.x = { type: logarithmic ? 'logarithmic' : 'linear', min: values[0], max: values.at(-1), title: { display: true, text: unit ? `${about} (${unit})` : about }, ticks: { callback: logarithmic && values.at(-1) / values[0] > 50 ? decade : (value) => shown(value, 4) } };
    nameAxis(scales.y, 'force P', unitOf('nN', own?.force_nN ?? 0));
    const place = (value) => (logarithmic ? Math.log(value) : value);
    const middle = place(now !== null && now >= values[0] ? now : values[0]);
    const order = [...values].sort((a, b) => Math.abs(place(a) - middle) - Math.abs(place(b) - middle));
    const others = scene.set.filter(([other]) => other !== key);
    let failed = 0;
    for (const value of order) {
      try {
        const text = unit ? `${written(value)} ${unit}` : written(value);
        const { summary } = await ask('api/peel', { ...scene, set: [...others, [key, text]] }, abort.signal);
        this.add(value, summary);
      } catch (error) {
        if (error.name === 'AbortError' || abort.signal.aborted) return;
        failed += 1;
      }
      this.chart.update('none');
    }
    this.tell(values.length, failed, control);
  }

  /** Puts a run into the chart. */
  add(value, summary) {
    const { peak, plateau, equilibria, kendall } = this.series;
    add(peak.data, value, summary.peak ?? summary.largest_force);
    add(plateau.data, value, summary.plateau);
    add(equilibria.data, value, summary.equilibria_peak);
    const force = summary.derived?.kendall_force_nN ?? null;
    add(kendall.data, value, force === null ? null : { force_nN: force });
  }

  tell(runs, failed, { about, unit }) {
    const best = this.series.peak.data.reduce((a, b) => (a && a.y >= b.y ? a : b), null);
    const force = unitOf('nN', best?.y ?? 0);
    const largest = best ? `The largest force is ${shown(best.y / force.factor, 4)} ${force.name}, at ${shown(best.x, 3)}${unit ? ` ${unit}` : ''}.` : 'No path has a peak.';
    this.text.textContent = `${runs} runs. ${largest}${failed ? ` ${failed} runs were refused.` : ''}`;
    this.canvas.setAttribute('aria-label', `Force against ${about}. ${this.text.textContent}`);
  }
}

function add(data, x, at) {
  if (!at) return;
  const place = data.findIndex((point) => point.x > x);
  data.splice(place < 0 ? data.length : place, 0, { x, y: at.force_nN });
}
