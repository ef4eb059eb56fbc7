// The page: what is dragged is asked of the server, and what it answers is shown.

import { ask, askForFile, Latest, Refusal } from './server.js';
import { Controls } from './controls.js';
import { CurveChart, KEPT } from './curve.js';
import { Sweep } from './sweep.js';
import * as beam from './beam.js';
import * as link from './link.js';
import * as results from './results.js';
import { unitsOf } from './units.js';

/** An answer that takes longer, ms, is given up for a newer request. */
const PATIENCE = 400;
/** After so long without a change, ms, the test, the link and the sweep are computed. */
const REST = 300;
/** An answer that takes longer, ms, is said to be awaited. */
const SLOW = 150;
/** Of the test that is played, ms for a place of the path. */
const FRAME = 60;
/** Most places of a pull at a rate that are played. */
const PLAYED = 200;

const part = (id) => document.getElementById(id);
const latest = new Latest(PATIENCE);
const state = { scene: null, set: new Map(), answer: null, observed: null, toml: '', kept: [], resting: null, times: [], asked: 0, rested: 0 };
// what a test of the page looks at
window.peel = state;

const chart = new CurveChart(part('curve-chart'), moveTo);
const sweep = new Sweep(part('sweep-chart'), part('sweep-text'), { key: part('sweep-key'), from: part('sweep-from'), to: part('sweep-to'), unit: part('sweep-unit') }, () => tryTo(sweepAgain));
const controls = new Controls(part('first-controls'), part('other-controls'), (key, text, isWord) => {
  if (text === null) state.set.delete(key);
  else state.set.set(key, text);
  state.changed = key;
  compute(isWord || text === null ? ['controls'] : []);
});

/** What stands on the page is that of the scene as it is now, or of the one before a change that is being computed or was refused. */
function mark(age) {
  const words = { current: '', computing: 'Computing. What is shown is from before the change.', refused: 'What is shown is from before the change.' };
  part('age').textContent = words[age];
  document.body.classList.toggle('old', age !== 'current');
  part('results').setAttribute('aria-busy', String(age === 'computing'));
}

/** The scene as it is asked for. */
const asked = () => ({ name: state.scene.name, scene: state.scene.text, set: [...state.set] });

/** Asks for the curve of the scene as it is now. */
function compute(parts = []) {
  state.asked += 1;
  clearTimeout(state.resting);
  sweep.stop();
  state.afterwards?.abort();
  clearTimeout(state.slow);
  state.slow = setTimeout(() => mark('computing'), SLOW);
  latest.ask(async (signal) => {
    const since = performance.now();
    try {
      const answer = await ask('api/peel', { ...asked(), parts: ['curve', 'poses', ...parts] }, signal);
      state.times.push(performance.now() - since);
      settle('current');
      controls.markWrong(null);
      show(answer);
      state.resting = setTimeout(rest, REST);
    } catch (error) {
      if (error instanceof Refusal) {
        settle('refused');
        controls.markWrong(state.changed);
      }
      tell(error);
    }
  });
}

/** Nothing is awaited any more. */
function settle(age) {
  clearTimeout(state.slow);
  mark(age);
}

/** Shows an answer. */
function show(answer) {
  const share = state.answer && chart.at / Math.max(1, state.answer.poses.along.length - 1);
  state.answer = answer;
  state.observed = null;
  const { summary, poses } = answer;
  state.units = unitsOf(answer.curve);
  part('title').textContent = summary.title;
  document.title = `${summary.title} – peel`;
  part('version').textContent = summary.version;
  if (answer.controls) controls.show(answer.controls, state.set);
  chart.show(answer, state.units);
  results.show(summary, state.units);
  part('beam-heading').textContent = answer.kind === 'seta' ? 'The seta there' : 'The beam there';
  beam.prepare(poses);
  const last = Math.max(0, poses.along.length - 1);
  part('place').max = last;
  moveTo(Math.round(share === null ? startPlace(summary, poses) : share * last));
  const ended = ['refused', 'failed', 'bound'].includes(summary.end);
  part('problem').replaceChildren(...(ended ? sentences(results.ending(summary)) : []));
}

/** The place of the peak, where a page begins. */
function startPlace(summary, { along }) {
  const peak = results.highest(summary);
  if (!peak) return 0;
  const away = ({ displacement_nm, force_nN }) =>
    Math.hypot(displacement_nm / peak.displacement_nm - 1, force_nN / peak.force_nN - 1);
  return along.reduce((best, pose, index) => (away(pose) < away(along[best]) ? index : best), 0);
}

/** Moves along the curve to a pose. */
function moveTo(index) {
  const pose = state.answer?.poses.along[index];
  if (!pose) {
    part('place-text').textContent = '';
    chart.move(-1);
    return;
  }
  chart.move(index);
  beam.draw(pose);
  const { u, p } = state.units;
  const stability = pose.unstable ? ', unstable under displacement control' : ', stable';
  const text = `u = ${results.inUnit(pose.displacement_nm, u)} ${u.name}, P = ${results.inUnit(pose.force_nN, p)} ${p.name}${state.answer.kind === 'rate' ? '' : stability}`;
  part('place').value = index;
  part('place').setAttribute('aria-valuetext', text);
  part('place-text').textContent = text;
}

/** Nothing has changed for a while: the sentence for who listens, the test, the link, the sweep. */
async function rest() {
  const { summary } = state.answer;
  const number = state.asked;
  part('sentence').textContent = results.sentence(summary, state.units);
  const abort = new AbortController();
  state.afterwards = abort;
  try {
    const answer = await ask('api/peel', { ...asked(), parts: ['test', 'toml', 'controls'] }, abort.signal);
    state.observed = answer.summary.observed ?? null;
    state.toml = answer.toml;
    chart.showJumps(state.observed);
    part('text').value = state.toml;
    history.replaceState(null, '', link.written({ name: state.scene.name, title: answer.summary.title, text: state.toml }));
    state.rested = number;
    sweep.offer(answer.controls);
    await sweepAgain();
  } catch (error) {
    tell(error);
  }
}

/** Computes the sweep of the key that is chosen. */
async function sweepAgain() {
  if (state.answer) await sweep.fill(asked(), state.answer.summary);
}

/** Does something, and tells of its error. */
function tryTo(work) {
  work().catch(tell);
}

/** Tells of an error in sentences; nothing of a request that was given up. */
function tell(error) {
  if (error.name === 'AbortError') return;
  if (!(error instanceof Refusal)) throw error;
  part('problem').replaceChildren(...sentences(error.message, error.remedy));
}

function sentences(...texts) {
  return texts.filter(Boolean).map((text) => {
    const paragraph = document.createElement('p');
    paragraph.textContent = text;
    return paragraph;
  });
}

/** Takes another scene. */
function open(scene) {
  state.scene = scene;
  state.set.clear();
  state.changed = null;
  state.answer = null;
  controls.forget();
  compute(['controls']);
}

/** Where a displacement-controlled test goes: along the stable path, and by jumps. */
function testPlaces() {
  const { along } = state.answer.poses;
  const jumps = (state.observed?.jumps ?? []).filter(({ way }) => way === 'retreat').map(({ after }) => after);
  const largest = Math.max(...along.map((pose) => Math.abs(pose.force_nN)), Number.MIN_VALUE);
  const places = [];
  for (let k = 0; k < along.length; k += 1) {
    if (!along[k].unstable) {
      places.push(k);
      continue;
    }
    const after = jumps.shift();
    if (!after) break;
    const away = (index) => Math.hypot((along[index].displacement_nm - after.displacement_nm) / (along.at(-1).displacement_nm || 1), (along[index].force_nN - after.force_nN) / largest);
    const landing = along.map((_, index) => index).filter((index) => index > k && !along[index].unstable)
      .reduce((best, index) => (best === null || away(index) < away(best) ? index : best), null);
    if (landing === null || away(landing) > 0.05) break;
    k = landing - 1;
  }
  const stride = Math.ceil(places.length / PLAYED);
  return places.filter((_, index) => index % stride === 0);
}

let playing = null;
function play() {
  clearInterval(playing);
  const places = testPlaces();
  part('play').textContent = 'Stop';
  playing = setInterval(() => {
    const next = places.shift();
    if (next === undefined) return stopPlaying();
    moveTo(next);
  }, FRAME);
}
function stopPlaying() {
  clearInterval(playing);
  playing = null;
  part('play').textContent = 'Play the test';
}

/** Keeps the curve of the scene as it is, for comparison. */
function keep() {
  if (!state.answer) return;
  if (state.kept.length === KEPT.length) return tell(new Refusal(`${KEPT.length} curves are kept already.`, 'Remove one of them.'));
  const { displacement_nm: u, force_nN: p, unstable } = state.answer.curve;
  const colour = KEPT.find((colour) => !state.kept.some((one) => one.colour === colour));
  const changes = [...state.set].map(([key, text]) => `${key.split('.')[1]} ${text}`).join(', ');
  const label = changes || state.answer.summary.title;
  state.kept.push({ label, colour, data: u.map((x, k) => ({ x, y: p[k] })), unstable });
  showKept();
}

function showKept() {
  chart.showKept(state.kept);
  part('kept').replaceChildren(...state.kept.map((one) => {
    const item = document.createElement('li');
    const swatch = document.createElement('span');
    swatch.className = 'swatch';
    swatch.style.background = one.colour;
    const remove = document.createElement('button');
    remove.type = 'button';
    remove.textContent = 'Remove';
    remove.setAttribute('aria-label', `Remove ${one.label}`);
    remove.addEventListener('click', () => {
      state.kept = state.kept.filter((other) => other !== one);
      showKept();
    });
    item.append(swatch, one.label, remove);
    return item;
  }));
}

async function download(file) {
  try {
    const blob = await askForFile({ ...asked(), file });
    const anchor = document.createElement('a');
    anchor.href = URL.createObjectURL(blob);
    anchor.download = file;
    anchor.click();
    setTimeout(() => URL.revokeObjectURL(anchor.href), 1000);
  } catch (error) {
    tell(error);
  }
}

async function copyLink() {
  try {
    await navigator.clipboard.writeText(location.href);
    part('notice').textContent = 'The link is copied. It holds the whole scene.';
  } catch {
    part('notice').textContent = `The link, which holds the whole scene: ${location.href}`;
  }
}

function listen() {
  part('place').addEventListener('input', () => { stopPlaying(); moveTo(Number(part('place').value)); });
  part('play').addEventListener('click', () => (playing ? stopPlaying() : play()));
  part('keep').addEventListener('click', keep);
  part('link').addEventListener('click', copyLink);
  part('use-text').addEventListener('click', () => open({ ...state.scene, text: part('text').value }));
  for (const button of document.querySelectorAll('[data-file]')) {
    button.addEventListener('click', () => download(button.dataset.file));
  }
  part('large').addEventListener('click', () => {
    const large = document.documentElement.classList.toggle('large');
    part('large').setAttribute('aria-pressed', String(large));
    chart.resize();
    sweep.resize();
  });
}

async function begin() {
  listen();
  const scenes = await ask('api/scenes');
  let linked = null;
  try {
    linked = link.read(location.hash);
  } catch {
    tell(new Refusal('The link does not hold a scene that can be read.', 'Copy the whole link.'));
  }
  if (linked) scenes.unshift({ ...linked, title: `${linked.title} (of the link)` });
  scenes.forEach(({ title }, index) => part('scenes').add(new Option(title, index)));
  part('scenes').addEventListener('change', () => open(scenes[part('scenes').value]));
  open(scenes[0]);
}

begin().catch(tell);
