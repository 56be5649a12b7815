// Opens a page of a file in Debian's Chromium and notes everything that must not happen.
import assert from 'node:assert/strict';
import { createHash } from 'node:crypto';
import { existsSync } from 'node:fs';
import { pathToFileURL } from 'node:url';
import { createRequire } from 'node:module';
import { join } from 'node:path';
import { after } from 'node:test';

// The package is looked for in the working directory first, so that it need not stand in the sources.
function loadPlaywright() {
  try {
    return createRequire(join(process.cwd(), 'package.json'))('playwright-core');
  } catch {
    return createRequire(import.meta.url)('playwright-core');
  }
}

const FLAGS = ['--headless=new', '--no-sandbox', '--disable-gpu', '--disable-quic', '--no-first-run',
  '--disable-background-networking', '--disable-component-update', '--disable-sync'];

function findChromium() {
  const found = [process.env.SPOKE_CHROMIUM, '/usr/bin/chromium', '/usr/bin/chromium-browser'].find((path) => path && existsSync(path));
  if (!found) throw new Error('no Chromium: install the Debian package chromium, or set SPOKE_CHROMIUM');
  return found;
}

// One browser per test file, since a start takes longer than most tests.
let browser = null;
after(async () => (await browser)?.close());

function startBrowser() {
  return loadPlaywright().chromium.launch({ executablePath: findChromium(), headless: true, args: FLAGS });
}

/**
 * Opens a file in a profile of its own, which shares no memory, storage or settings with those before.
 * `problems` collects errors on the console, exceptions of the page and every request but
 * file:, data: and blob:, as they happen. Call close() at the end.
 */
export async function openPage(file, { width = 1280, height = 800, scheme = 'light' } = {}) {
  browser ??= startBrowser();
  const context = await (await browser).newContext({ viewport: { width, height }, colorScheme: scheme });
  const page = await context.newPage();
  const problems = [];
  page.on('console', (message) => {
    if (message.type() === 'error') problems.push(`console: ${message.text()}`);
  });
  page.on('pageerror', (error) => problems.push(`exception: ${error.message}`));
  page.on('request', (request) => {
    if (!/^(file|data|blob):/.test(request.url())) problems.push(`request: ${request.url()}`);
  });
  await page.goto(pathToFileURL(file).href);
  return { page, problems, close: () => context.close() };
}

/**
 * Shows `look` the page of a file whose modes do not move by themselves, so that pictures can be
 * compared. Nothing that openPage() notes may happen.
 */
export async function withStillPage(file, options, look) {
  const { page, problems, close } = await openPage(file, options);
  try {
    await page.emulateMedia({ reducedMotion: 'reduce', colorScheme: options.scheme ?? 'light' });
    await page.reload();
    await look(page);
    assert.deepEqual(problems, []);
  } finally {
    await close();
  }
}

/** A digest of all pixels of a canvas. */
export async function picture(canvas) {
  const pixels = await canvas.evaluate((element) => element.toDataURL());
  return createHash('sha256').update(pixels).digest('hex');
}
