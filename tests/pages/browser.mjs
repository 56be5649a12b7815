// Opens a page of a file in Debian's Chromium and notes everything that must not happen.
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
