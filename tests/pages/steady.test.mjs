// Pages of equilibria, modes and Campbell diagrams in a browser. SPOKE_PROGRAM: the built program;
// SPOKE_MODELS_DIR: the folder of the shipped scenarios.
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { mkdtempSync, readFileSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { after, test } from 'node:test';

import { picture, withStillPage } from './browser.mjs';

const folder = mkdtempSync(join(tmpdir(), 'spoke-steady-'));
after(() => rmSync(folder, { recursive: true, force: true }));

/** The folder with the results of a command about a shipped scenario. */
function solve(command, name, ...options) {
  const out = join(folder, `${command}-${name}`);
  const scenario = join(process.env.SPOKE_MODELS_DIR, `${name}.toml`);
  execFileSync(process.env.SPOKE_PROGRAM, [command, scenario, '--out', out, ...options], { stdio: 'pipe' });
  return out;
}

const campbell = solve('campbell', 'articulated_rotor', '--speeds', '0:44:4', '--count', '4');
const equilibrium = solve('static', 'nrel_5mw_rotor');
const turbine = solve('static', 'nrel_5mw_in_wind', '--speed', '1.267');
const performance = solve('performance', 'nrel_5mw_in_wind', '--wind', '8:12:4', '--rigid');
const free = solve('modes', 'satellite_booms', '--speed', '0', '--count', '12');

const pages = [join(campbell, 'campbell.html'), join(equilibrium, 'static.html'), join(free, 'modes.html'),
  join(turbine, 'static.html'), join(performance, 'performance.html')];

/** Titles of the charts of a page. */
const titlesOf = (page) => page.$$eval('svg.chart .title', (found) => found.map((title) => title.textContent));
for (const scheme of ['light', 'dark'])
  for (const width of [400, 1280])
    test(`pages fit into ${width} pixels, ${scheme}`, async () => {
      for (const file of pages)
        await withStillPage(file, { width, scheme }, async (page) => {
          const overflow = await page.evaluate(() => document.documentElement.scrollWidth - innerWidth);
          assert.ok(overflow <= 0, `${file}: wider than the window by ${overflow}`);
        });
    });

test('deflections of an equilibrium are shown larger', () =>
  withStillPage(pages[1], {}, async (page) => {
    const canvas = page.locator('#steady-view');
    const before = await picture(canvas);
    await page.locator('#steady-scale').fill('100');
    assert.equal(await page.locator('#steady-times').textContent(), '\u00d7 10');
    assert.notEqual(await picture(canvas), before);
  }));

test('the diagram zooms by a rectangle, and back', () =>
  withStillPage(pages[0], {}, async (page) => {
    const canvas = page.locator('#campbell');
    const before = await picture(canvas);
    const box = await canvas.boundingBox();
    assert.ok(await page.locator('#campbell-reset').isDisabled());
    await page.mouse.move(box.x + 100, box.y + 60);
    await page.mouse.down();
    await page.mouse.move(box.x + 300, box.y + 200, { steps: 4 });
    await page.mouse.up();
    assert.notEqual(await picture(canvas), before);
    await page.locator('#campbell-reset').click();
    await page.mouse.move(0, 0);
    assert.equal(await picture(canvas), before);
  }));

test('modes are read below the pointer, chosen by keys, and their shapes follow', () =>
  withStillPage(pages[0], {}, async (page) => {
    const { branches } = JSON.parse(readFileSync(join(campbell, 'campbell.json'), 'utf8'));
    const text = page.locator('#mode-text');
    const view = page.locator('#mode-view');
    await page.locator('#mode-mode').selectOption('1');
    await page.locator('#mode-speed').selectOption('11');
    assert.match(await text.textContent(), new RegExp(`${branches[1].mode} at 44 rad/s`));
    const before = await picture(view);
    await page.locator('#campbell').focus();
    await page.keyboard.press('ArrowLeft');
    assert.match(await text.textContent(), new RegExp(`${branches[1].mode} at 40 rad/s`));
    assert.match(await page.locator('#spoken').textContent(), /at 40 rad\/s/);
    assert.equal(await page.locator('#mode-speed').inputValue(), '10');
    await page.keyboard.press('ArrowUp');
    assert.notEqual(await page.locator('#mode-mode').inputValue(), '1');
    assert.notEqual(await picture(view), before);
  }));

test('a chosen mode moves, the free hub too, and stops', () =>
  withStillPage(pages[2], {}, async (page) => {
    const view = page.locator('#mode-view');
    await page.locator('#mode-mode').selectOption('8');
    const still = await picture(view);
    await page.locator('#mode-play').click();
    await page.waitForTimeout(1200);
    await page.locator('#mode-play').click();
    const stopped = await picture(view);
    assert.notEqual(stopped, still);
    await page.waitForTimeout(700);
    assert.equal(await picture(view), stopped);
    await page.locator('#mode-amplitude').fill('0');
    assert.notEqual(await picture(view), stopped);
  }));

test('a turbine in equilibrium has charts along blade and support, with the values of static.json', () =>
  withStillPage(pages[3], {}, async (page) => {
    assert.deepEqual(await titlesOf(page), ['Deflection along the axis of rotation', 'Deflection in the plane of rotation',
      'Displacement of the support', 'Angle of attack', 'Relative speed', 'Induction factors',
      'Coefficients of lift, drag and moment', 'Forces by length']);
    const { blades } = JSON.parse(readFileSync(join(turbine, 'static.json'), 'utf8'));
    const charts = page.locator('svg.chart');
    const attack = (await charts.nth(3).locator('g title').allTextContents()).filter((text) => text.includes('attack '));
    assert.equal(attack.length, blades[0].air.length);
    blades[0].air.forEach((section, k) => {
      const found = Number(attack[k].match(/(-?[\d.e-]+) deg$/)[1]);
      const expected = (section.angle_of_attack_rad * 180) / Math.PI;
      assert.ok(Math.abs(found - expected) <= 6e-3 * Math.abs(expected), `${attack[k]}, not ${expected}`);
    });
    assert.match(await page.locator('figure').filter({ hasText: 'Deflection along' }).textContent(), /Of blade 1, blade 2, blade 3/);
    assert.match(await charts.nth(2).textContent(), /along x.*along z/s);
  }));

test('the page of performance has curves and a table of its points', () =>
  withStillPage(pages[4], {}, async (page) => {
    assert.deepEqual(await titlesOf(page), ['Power', 'Thrust', 'Speed', 'Pitch', 'Power coefficient', 'Thrust coefficient']);
    const { points } = JSON.parse(readFileSync(join(performance, 'performance.json'), 'utf8'));
    const rows = await page.locator('tbody tr').evaluateAll((found) =>
      found.map((row) => [...row.querySelectorAll('td')].map((cell) => Number(cell.textContent))));
    assert.deepEqual(rows.map((row) => row[4]), points.map((point) => Number((point.power_W / 1000).toPrecision(6))));
  }));
