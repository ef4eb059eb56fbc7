// The page of peel serve in Chromium. What is dragged is what is shown; its numbers are those of `peel run`; errors are sentences; nothing
// is loaded from elsewhere, and the console stays empty.
//
//     npm ci && npm test        after: cargo build --release --bin peel

import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { readFileSync } from 'node:fs';
import { after, before, test } from 'node:test';
import { PEEL, ROOT, browse, open, put, serve, settled } from './browser.js';

const STRIP = 'scenes/strip-100nm.toml';
let server;
let browser;
before(async () => {
  server = await serve();
  browser = await browse();
});
after(async () => {
  await browser.close();
  assert.equal(await server.end(), 0, 'Ctrl-C ends the server');
});

/** What the command computes. */
function run(...set) {
  const args = set.flatMap((one) => ['--set', one]);
  return JSON.parse(execFileSync(PEEL, ['run', STRIP, '--json', ...args], { cwd: ROOT }));
}

/** A number as the page writes it. */
const written = (number) => String(Number(number.toPrecision(6)));

const rowOf = (page, name) => page.locator('#numbers tr', { has: page.getByRole('rowheader', { name, exact: true }) }).locator('td');

async function numbersOf(page, name) {
  const cells = await rowOf(page, name).allInnerTexts();
  return cells.map((text) => text.split(' ')[0]);
}

/** Opens the page for one test, and closes it without a mistake. */
function on(name, work, address = () => server.address) {
  test(name, async () => {
    const { page, mistakes, elsewhere } = await open(browser.context, address());
    await work(page, mistakes);
    assert.deepEqual(mistakes, [], 'nothing goes wrong in the page');
    assert.deepEqual(elsewhere, [], 'nothing is loaded from elsewhere');
    await page.close();
  });
}

on('numbers are those of the command', async (page) => {
  for (const [height, set] of [[null, []], ['8', ['strip.height=8 nm']]]) {
    if (height) await put(page, '[aria-label^="height h of the section, as a number"]', height, 'change');
    await settled(page);
    const summary = run(...set);
    const { displacement_nm, force_nN } = summary.initiation_peak;
    assert.deepEqual(await numbersOf(page, 'Initiation peak'), [written(displacement_nm), written(force_nN)]);
    assert.deepEqual(await numbersOf(page, 'First jump'), [written(summary.first_jump.displacement_nm), written(summary.first_jump.force_nN)]);
    assert.equal((await numbersOf(page, 'Kendall’s force'))[1], written(summary.derived.kendall_force_nN));
  }
});

on('what is dragged is what is shown', async (page) => {
  const slider = page.locator('[id="key-strip.length"]');
  const box = await slider.boundingBox();
  const y = box.y + box.height / 2;
  await page.mouse.move(box.x + box.width / 2, y);
  await page.mouse.down();
  for (let step = 1; step <= 20; step += 1) await page.mouse.move(box.x + box.width * (0.5 - 0.015 * step), y);
  await page.mouse.up();
  await settled(page);
  const shown = await page.locator('[aria-label^="length L of the strip, as a number"]').inputValue();
  assert.ok(Number(shown) < 60, shown);
  const { parameters } = await page.evaluate(() => window.peel.answer.summary);
  assert.equal(parameters.strip.length_nm ?? Number(shown), Number(shown));
  const summary = run(`strip.length=${shown} nm`);
  assert.equal((await numbersOf(page, 'Initiation peak'))[1], written(summary.initiation_peak.force_nN));
});

on('the place follows the pointer along the curve, and the beam with it', async (page) => {
  const before = await page.locator('#beam .outline').getAttribute('points');
  const target = await page.evaluate(() => {
    const chart = Chart.getChart('curve-chart');
    const along = window.peel.answer.poses.along;
    const index = along.findIndex((pose) => pose.unstable);
    const box = chart.canvas.getBoundingClientRect();
    const place = (pose) => [box.left + chart.scales.x.getPixelForValue(pose.displacement_nm), box.top + chart.scales.y.getPixelForValue(pose.force_nN)];
    return { from: place(along[index - 4]), to: place(along[index - 1]), pose: along[index - 1] };
  });
  await page.mouse.move(...target.from);
  await page.mouse.down();
  await page.mouse.move(...target.to, { steps: 5 });
  await page.mouse.up();
  const text = await page.locator('#place-text').innerText();
  const [u] = text.match(/[\d.e+-]+/);
  assert.ok(Math.abs(Number(u) / target.pose.displacement_nm - 1) < 0.02, `${text}: ${target.pose.displacement_nm}`);
  assert.notEqual(await page.locator('#beam .outline').getAttribute('points'), before);
});

on('the unstable part is dashed, and the beam on it as well', async (page) => {
  const index = await page.evaluate(() => window.peel.answer.poses.along.findIndex((pose) => pose.unstable));
  await put(page, '#place', String(index));
  assert.match(await page.locator('#place-text').innerText(), /unstable under displacement control$/);
  assert.equal(await page.locator('#beam .outline').getAttribute('class'), 'outline unstable');
  const dash = await page.evaluate(() => Chart.getChart('curve-chart').data.datasets.find(({ label }) => label.startsWith('unstable')).borderDash);
  assert.deepEqual(dash, [8, 5]);
});

on('jumps are those of the observed test', async (page) => {
  const jumps = await page.evaluate(() => window.peel.observed.jumps);
  const { observed } = JSON.parse(execFileSync(PEEL, ['run', STRIP, '--json', '--observed'], { cwd: ROOT }));
  assert.equal(jumps.length, observed.jumps.length);
  assert.equal(jumps[0].before.force_nN, observed.jumps[0].before.force_nN);
  const drawn = await page.evaluate(() => Chart.getChart('curve-chart').data.datasets.find(({ label }) => label.startsWith('jumps')).data[0]);
  assert.equal(drawn.x, jumps[0].before.displacement_nm);
});

on('the test is played: stable places alone, and a jump past the others', async (page) => {
  await page.click('#play');
  const seen = new Set();
  const since = Date.now();
  while ((await page.locator('#play').innerText()) === 'Stop' && Date.now() - since < 60_000) {
    seen.add(await page.locator('#place-text').innerText());
    await page.waitForTimeout(20);
  }
  assert.ok(seen.size > 5);
  assert.ok([...seen].slice(1).every((text) => text.endsWith(' stable')), [...seen].join('\n'));
});

on('the sweep fills in, with the numbers of the command', async (page) => {
  await page.waitForFunction(() => document.getElementById('sweep-text').textContent, null, { timeout: 120_000 });
  const points = await page.evaluate(() => Chart.getChart('sweep-chart').data.datasets.find(({ label }) => label === 'peak').data);
  assert.equal(points.length, 33);
  const one = points.find(({ x }) => Math.abs(x - 1) < 1e-9);
  assert.equal(one.y, run().peak.force_nN);
  assert.ok(points.every(({ x }, index) => index === 0 || x > points[index - 1].x));
});

on('the sweep goes over another key', async (page) => {
  await page.selectOption('#sweep-key', 'strip.height');
  await put(page, '#sweep-from', '8', 'change');
  await put(page, '#sweep-to', '12', 'change');
  await page.waitForFunction(() => document.getElementById('sweep-text').textContent.startsWith('33 runs'), null, { timeout: 120_000 });
  const { data, title } = await page.evaluate(() => {
    const chart = Chart.getChart('sweep-chart');
    return { data: chart.data.datasets.find(({ label }) => label === 'peak').data, title: chart.options.scales.x.title.text };
  });
  assert.deepEqual([data.length, data[0].x, data.at(-1).x, title], [33, 8, 12, 'height h of the section (nm)']);
  assert.equal(data[0].y, run('strip.height=8 nm').peak.force_nN);
  const keys = await page.locator('#sweep-key option').evaluateAll((options) => options.map(({ value }) => value));
  assert.ok(['strip.length', 'adhesion.hamaker_constant', 'drive.angle', 'accuracy.relative'].every((key) => keys.includes(key)), keys.join());
});

on('a wrong value is told in a sentence, and the page goes on', async (page, mistakes) => {
  await put(page, '[aria-label^="height h of the section, as a number"]', '-3', 'change');
  await page.waitForFunction(() => document.getElementById('problem').textContent);
  const said = await page.locator('#problem').innerText();
  assert.match(said, /^`strip.height` is -3 nm, which is out of range\s+`height` takes a length above zero/);
  assert.equal(await page.locator('#problem').getAttribute('role'), 'alert');
  // the browser itself notes that an answer was a refusal
  assert.ok(mistakes.every((text) => text.includes('422')), mistakes.join('\n'));
  mistakes.length = 0;
  const field = page.locator('[aria-label^="height h of the section, as a number"]');
  assert.equal(await field.getAttribute('aria-invalid'), 'true');
  assert.equal(await page.locator('[aria-invalid]').count(), 2, 'the slider and the field of this key alone');
  assert.equal(await page.locator('#age').innerText(), 'What is shown is from before the change.');
  assert.match(await page.locator('body').getAttribute('class'), /old/);
  await put(page, '[aria-label^="height h of the section, as a number"]', '9', 'change');
  await settled(page);
  assert.equal(await page.locator('#problem').innerText(), '');
  assert.equal(await page.locator('[aria-invalid]').count(), 0);
  assert.equal(await page.locator('#age').innerText(), '');
});

on('an emptied field, and a reset, are those of the scene again', async (page, mistakes) => {
  const field = page.locator('[aria-label^="height h of the section, as a number"]');
  const reset = page.getByRole('button', { name: /^Reset height h of the section/ });
  const peak = await numbersOf(page, 'Initiation peak');
  assert.equal(await reset.isVisible(), false, 'nothing is to be reset yet');
  await put(page, '[aria-label^="height h of the section, as a number"]', '-3', 'change');
  await page.waitForFunction(() => document.getElementById('problem').textContent);
  mistakes.length = 0;
  await put(page, '[aria-label^="height h of the section, as a number"]', '', 'change');
  await settled(page);
  assert.equal(await page.locator('#problem').innerText(), '');
  assert.equal(await field.inputValue(), '10');
  await put(page, '[aria-label^="height h of the section, as a number"]', '7', 'change');
  await settled(page);
  assert.notDeepEqual(await numbersOf(page, 'Initiation peak'), peak);
  await reset.click();
  await settled(page);
  assert.deepEqual(await numbersOf(page, 'Initiation peak'), peak);
  assert.equal(await reset.isVisible(), false);
});

on('axes have the unit that fits', async (page) => {
  const titles = () => page.evaluate(() => Object.values(Chart.getChart('curve-chart').options.scales).map((axis) => axis.title.text));
  assert.deepEqual(await titles(), ['displacement u (nm)', 'force P (nN)']);
  await put(page, '[aria-label^="length L of the strip, as a number"]', '4000', 'change');
  await settled(page);
  assert.equal((await titles())[0], 'displacement u (µm)');
});

on('another law is chosen, and its keys are there', async (page) => {
  await page.selectOption('[id="key-adhesion.law"]', 'bilinear');
  await settled(page);
  const summary = run('adhesion.law=bilinear');
  assert.equal((await numbersOf(page, 'Initiation peak'))[1], written(summary.initiation_peak.force_nN));
});

on('a link holds the scene', async (page) => {
  await put(page, '[aria-label^="height h of the section, as a number"]', '7', 'change');
  await settled(page);
  const { page: other, mistakes } = await open(browser.context, page.url());
  assert.equal(await other.locator('[aria-label^="height h of the section, as a number"]').inputValue(), '7');
  assert.deepEqual(await numbersOf(other, 'Initiation peak'), await numbersOf(page, 'Initiation peak'));
  assert.deepEqual(mistakes, []);
  await other.close();
});

on('scene, table, picture and summary are downloaded', async (page) => {
  for (const [file, begins] of [['parameters.toml', /\[strip\]/], ['curve.csv', /^displacement_nm,force_nN/], ['curve.svg', /^<svg/], ['summary.json', /^\{\n {2}"version"/]]) {
    const [download] = await Promise.all([page.waitForEvent('download'), page.click(`[data-file="${file}"]`)]);
    assert.equal(download.suggestedFilename(), file);
    assert.match(readFileSync(await download.path(), 'utf8'), begins);
  }
});

on('a curve is kept beside others, and removed', async (page) => {
  await page.click('#keep');
  await put(page, '[aria-label^="height h of the section, as a number"]', '12', 'change');
  await settled(page);
  await page.click('#keep');
  const labels = () => page.evaluate(() => Chart.getChart('curve-chart').data.datasets.map(({ label }) => label));
  assert.ok((await labels()).includes('height 12 nm'));
  assert.equal(await page.locator('#kept li').count(), 2);
  await page.getByRole('button', { name: 'Remove height 12 nm' }).click();
  assert.ok(!(await labels()).includes('height 12 nm'));
});

on('everything is reached and worked by the keyboard, and has a name', async (page) => {
  await page.locator('[id="key-strip.length"]').focus();
  await page.keyboard.press('ArrowLeft');
  await settled(page);
  assert.notEqual(await page.locator('[id="key-strip.length"]').inputValue(), '500');
  assert.match(await page.locator('[id="key-strip.length"]').getAttribute('aria-valuetext'), /^[\d.]+ nm$/);
  await page.locator('#place').focus();
  const before = await page.locator('#place-text').innerText();
  await page.keyboard.press('ArrowRight');
  assert.notEqual(await page.locator('#place-text').innerText(), before);
  const nameless = await page.evaluate(() => [...document.querySelectorAll('input, select, button, textarea')]
    .filter((one) => !one.labels?.length && !one.getAttribute('aria-label') && !one.textContent.trim()).map((one) => one.outerHTML));
  assert.deepEqual(nameless, []);
  assert.match(await page.locator('#curve-chart').getAttribute('aria-label'), /largest force 0\.\d+ nN/);
  assert.match(await page.locator('#sentence').innerText(), /^Peak 0\.\d+ nN/);
});

on('it fits the width of a phone, and a lecture hall', async (page) => {
  // charts take the new width when the browser has laid the page out
  const fits = () => page.waitForFunction(() => document.documentElement.scrollWidth <= document.documentElement.clientWidth, null, { timeout: 5000 });
  await page.setViewportSize({ width: 390, height: 844 });
  await fits();
  await page.setViewportSize({ width: 1600, height: 1000 });
  await page.click('#large');
  await fits();
  assert.equal(await page.evaluate(() => getComputedStyle(document.body).fontSize), '24px');
  await page.setViewportSize({ width: 1280, height: 1000 });
});

for (const [title, name] of [['Strip on wavy ground', 'Peeling of a strip from a wavy surface'], ['Spatula', "Peeling of a gecko's spatula"]]) {
  on(`${title} as well as the strip`, async (page) => {
    await page.selectOption('#scenes', { label: title });
    await page.waitForFunction((name) => document.getElementById('title').textContent === name, name, { timeout: 120_000 });
    const { along, ground } = await page.evaluate(() => window.peel.answer.poses);
    assert.ok(along.length > 20 && ground.length >= 4);
    assert.notEqual(await page.locator('#beam .outline').getAttribute('points'), null);
  });
}

/** Takes one of the scenes that the page offers. */
async function take(page, label, title) {
  await page.selectOption('#scenes', { label });
  await page.waitForFunction((title) => document.getElementById('title').textContent === title, title, { timeout: 120_000 });
  await settled(page);
}

const scene = (name) => JSON.parse(execFileSync(PEEL, ['run', `scenes/${name}.toml`, '--json'], { cwd: ROOT }));

on('a seta is drawn, with the numbers of the command', async (page) => {
  await take(page, 'Seta', 'Pull-off of a seta with 256 spatulae');
  const { peak } = scene('seta');
  assert.deepEqual(await numbersOf(page, 'Peak'), [written(peak.displacement_nm / 1000), written(peak.force_nN)]);
  assert.match(await page.locator('#results thead').innerText(), /u \(µm\)\s+P \(nN\)/);
  assert.match(await page.locator('#sentence').innerText(), /239 of 256 tips adhere/);
  await put(page, '#place', '0');
  assert.equal(await page.locator('#beam .branch').count(), 511);
  assert.equal(await page.locator('#beam .branch.detached').count(), 0);
  await put(page, '#place', await page.locator('#place').getAttribute('max'));
  assert.equal(await page.locator('#beam .branch.detached').count(), 511);
});

on('a pull at a rate is drawn beside its equilibria, with the numbers of the command', async (page) => {
  await take(page, 'Strip at a rate', 'Peeling of a strip of 100 nm at 1 mm/s');
  const { largest_force, equilibria_peak } = scene('strip-at-a-rate');
  assert.deepEqual(await numbersOf(page, 'Largest force'), [written(largest_force.displacement_nm), written(largest_force.force_nN)]);
  assert.equal((await numbersOf(page, 'Peak of the equilibria'))[1], written(equilibria_peak.force_nN));
  const drawn = await page.evaluate(() => Chart.getChart('curve-chart').data.datasets.map(({ label, data }) => [label, data.length]));
  assert.ok(drawn.some(([label, length]) => label === 'equilibria' && length > 50), drawn.join());
  assert.ok(await page.locator('#beam').isHidden(), 'no shape is known');
});

on('a tape has the units of a tape', async (page) => {
  await take(page, 'Adhesive tape', 'Peeling of a tape');
  const titles = await page.evaluate(() => Object.values(Chart.getChart('curve-chart').options.scales).map((axis) => axis.title.text));
  assert.deepEqual(titles, ['displacement u (mm)', 'force P (N)']);
  assert.match(await page.locator('#place-text').innerText(), /^u = [\d.]+ mm, P = [\d.]+ N,/);
});

// Printed and not asserted: other work on the machine changes it.
on('how long a drag waits for its curve', async (page) => {
  await page.evaluate(async () => {
    window.peel.times.length = 0;
    const slider = document.getElementById('key-strip.length');
    for (let k = 0; k < 200; k += 1) {
      slider.value = 400 + (k % 100);
      slider.dispatchEvent(new Event('input'));
      await new Promise((done) => setTimeout(done, 60));
    }
  });
  await settled(page);
  const times = (await page.evaluate(() => window.peel.times)).sort((a, b) => a - b);
  const share = (part) => times[Math.min(times.length - 1, Math.floor(part * times.length))].toFixed(0);
  console.log(`# ${times.length} answers while one drags: half within ${share(0.5)} ms, 95 % within ${share(0.95)} ms`);
});
