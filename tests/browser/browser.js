// A server, and a page in Chromium that reports whatever goes wrong in it.

import { spawn } from 'node:child_process';
import { mkdtempSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { chromium } from 'playwright-core';

export const ROOT = join(import.meta.dirname, '../..');
/** The command; `PEEL` names another one than that of the release build. */
export const PEEL = process.env.PEEL ?? join(process.env.CARGO_TARGET_DIR ?? join(ROOT, 'target'), 'release/peel');
const CHROMIUM = process.env.CHROMIUM ?? '/usr/bin/chromium';
const FLAGS = ['--no-sandbox', '--disable-gpu', '--disable-quic', '--no-first-run', '--disable-background-networking', '--disable-component-update', '--disable-sync'];

/** A server on a free port: its address, and what ends it. */
export async function serve(...args) {
  const child = spawn(PEEL, ['serve', '--port', '0', ...args], { cwd: ROOT, stdio: ['ignore', 'pipe', 'inherit'] });
  const address = await new Promise((found, failed) => {
    let said = '';
    child.stdout.on('data', (data) => {
      said += data;
      const at = said.match(/http:\/\/\S+/);
      if (at) found(at[0]);
    });
    child.on('exit', (status) => failed(new Error(`peel serve ended with ${status}`)));
  });
  const ended = new Promise((done) => child.on('exit', (status, signal) => done(status ?? signal)));
  const end = () => {
    child.kill('SIGINT');
    return ended;
  };
  return { address, end };
}

/** A browser with a folder of its own. */
export async function browse() {
  const folder = mkdtempSync(join(tmpdir(), 'peel-browser-'));
  const context = await chromium.launchPersistentContext(folder, { executablePath: CHROMIUM, headless: true, args: FLAGS, viewport: { width: 1280, height: 1000 }, acceptDownloads: true });
  const close = async () => {
    await context.close();
    rmSync(folder, { recursive: true, force: true });
  };
  return { context, close };
}

/** The page, computed once; `mistakes` fills with what goes wrong, `elsewhere` with what is loaded from other addresses. */
export async function open(context, address) {
  const page = await context.newPage();
  const mistakes = [];
  const elsewhere = [];
  page.on('pageerror', (error) => mistakes.push(error.stack));
  page.on('console', (message) => { if (['error', 'warning'].includes(message.type())) mistakes.push(message.text()); });
  page.on('request', (request) => { if (!/^(blob|data):/.test(request.url()) && !request.url().startsWith(new URL(address).origin)) elsewhere.push(request.url()); });
  await page.goto(address);
  await settled(page);
  return { page, mistakes, elsewhere };
}

/** Waits until the page shows what it has asked for, with its link and its test. */
export async function settled(page) {
  await page.waitForFunction(() => window.peel?.answer && window.peel.rested === window.peel.asked, null, { timeout: 120_000 });
}

/** Moves a slider or a field as a user does: the value, and what a browser says of it. */
export async function put(page, selector, value, event = 'input') {
  await page.locator(selector).evaluate((element, [value, event]) => {
    element.value = value;
    element.dispatchEvent(new Event(event, { bubbles: true }));
  }, [value, event]);
}
