// The pages of peel run --animate in Chromium: they play by themselves, reach their end, stop where the slider is put, and say nothing in the
// console.
//
//     npm ci && npm test        after: cargo build --release --bin peel

import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { mkdtempSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { after, before, test } from 'node:test';
import { pathToFileURL } from 'node:url';
import { PEEL, ROOT, browse, put } from './browser.js';

const SEVERAL = ['seta.forks=2', 'seta.shaft_length=7 um', 'seta.brush_height=3 um', 'seta.shaft_diameter=240 nm', 'seta.height_scatter=20 nm'];
let browser;
let folder;
before(async () => {
  browser = await browse();
  folder = mkdtempSync(join(tmpdir(), 'peel-animation-'));
});
after(async () => {
  await browser.close();
  rmSync(folder, { recursive: true, force: true });
});

/** What moves, as text. */
const moving = (page) => page.locator('#beam, .p0').evaluateAll((all) => all.map((one) => one.getAttribute('points') ?? one.getAttribute('d')).join());

for (const [name, scene, set] of [['a strip', 'scenes/strip-100nm.toml', []], ['a seta', 'scenes/seta.toml', SEVERAL]]) {
  test(`${name} plays`, async () => {
    const out = join(folder, name.replace(' ', '-'));
    execFileSync(PEEL, ['run', scene, '--animate', '--out', out, ...set.flatMap((one) => ['--set', one])], { cwd: ROOT });
    const page = await browser.context.newPage();
    const mistakes = [];
    page.on('pageerror', (error) => mistakes.push(error.stack));
    page.on('console', (message) => mistakes.push(message.text()));
    await page.goto(pathToFileURL(join(out, 'animation.html')).href);
    const says = () => page.locator('#says').innerText();
    const first = await moving(page);
    await page.waitForFunction(() => Number(document.getElementById('time').value) > 0.2, null, { timeout: 20_000 });
    assert.notEqual(await moving(page), first, 'the picture changes');

    // where the slider is put it stays
    await put(page, '#time', '1');
    const [last, end] = [await moving(page), await says()];
    await page.waitForTimeout(300);
    assert.equal(await moving(page), last);
    assert.equal(await page.locator('#play').innerText(), 'Play');
    await put(page, '#time', '0');
    assert.notEqual(await moving(page), last);

    // from just before the end it plays past it, and there it shows the last frame
    await put(page, '#time', '0.99');
    await page.locator('#play').click();
    await page.waitForFunction((end) => document.getElementById('says').textContent === end, end, { timeout: 20_000 });
    assert.deepEqual(mistakes, []);
    await page.close();
  });
}
