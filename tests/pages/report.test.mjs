// The page of a run, report.html, in a browser. SPOKE_PROGRAM: the built program; SPOKE_MODELS_DIR:
// the folder of the shipped scenarios.
import assert from 'node:assert/strict';
import { execFileSync, spawnSync } from 'node:child_process';
import { mkdtempSync, readFileSync, rmSync, statSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { after, test } from 'node:test';

import { openPage } from './browser.mjs';

const folder = mkdtempSync(join(tmpdir(), 'spoke-report-'));
after(() => rmSync(folder, { recursive: true, force: true }));

/** Runs a shipped scenario; the folder of its results. */
function run(name, ...options) {
  const out = join(folder, name);
  const model = join(process.env.SPOKE_MODELS_DIR, `${name}.toml`);
  execFileSync(process.env.SPOKE_PROGRAM, ['run', model, '--quiet', '--out', out, ...options]);
  return out;
}

const rotor = run('wu_haug_rotor');
const rotorPage = join(rotor, 'report.html');

/** Opens a page, hands it over, and demands that nothing went wrong meanwhile. */
async function withPage(file, options, look) {
  const { page, problems, close } = await openPage(file, options);
  try {
    await look(page);
    assert.deepEqual(problems, []);
  } finally {
    await close();
  }
}

const plotOf = (page, title) => page.locator('.plot').filter({ hasText: title });

/** Number of pixels of a canvas that are not transparent. */
const countPixels = (canvas) =>
  canvas.evaluate((element) => {
    const { data } = element.getContext('2d').getImageData(0, 0, element.width, element.height);
    let count = 0;
    for (let k = 3; k < data.length; k += 4) count += data[k] > 0;
    return count;
  });

/** All pixels of a canvas in one text. */
const picture = (canvas) => canvas.evaluate((element) => element.toDataURL());

/** The time window that the page says it shows. */
async function shownWindow(page) {
  const text = await page.locator('#plots-shown').textContent();
  return text.match(/[\d.]+/g).map(Number);
}

for (const scheme of ['light', 'dark'])
  for (const width of [400, 1280, 1920])
    test(`the rotor's page is drawn at ${width} pixels, ${scheme}`, () =>
      withPage(rotorPage, { width, scheme }, async (page) => {
        assert.equal(await page.locator('h1').textContent(), 'Wu & Haug 1988 rotor, spin-up to 4 rad/s');
        const plots = page.locator('.plot');
        assert.equal(await plots.count(), 8);
        for (let k = 0; k < 8; ++k)
          assert.ok((await countPixels(plots.nth(k).locator('canvas').first())) > 1000);
        for (const view of ['#animation-hub', '#animation-inertial'])
          assert.ok((await countPixels(page.locator(view))) > 1000);
        const overflow = await page.evaluate(() => document.documentElement.scrollWidth - innerWidth);
        assert.ok(overflow <= 0, `wider than the window by ${overflow}`);
      }));

test('hovering reads values in all plots, and they are those of sensors.csv', () =>
  withPage(rotorPage, {}, async (page) => {
    const rows = readFileSync(join(rotor, 'sensors.csv'), 'utf8').trim().split('\n').map((row) => row.split(','));
    const column = (name) => rows[0].indexOf(name);
    const deflection = plotOf(page, 'Tip deflection across');
    const canvas = deflection.locator('canvas').first();
    await canvas.focus();
    await page.keyboard.press('Home');
    for (let k = 0; k < 5; ++k) await page.keyboard.press('Shift+ArrowRight'); // 10 s
    const row = rows.find((cells) => cells[0] === '10');
    const read = async (title) => {
      const text = await plotOf(page, title).locator('output').first().textContent();
      return Number(text.replace('\u2212', '-').split(' ')[0]);
    };
    const near = (found, expected) => assert.ok(Math.abs(found - expected) <= 1e-4 * Math.abs(expected) + 1e-9, `${found}, not ${expected}`);
    near(await read('Tip deflection across'), Number(row[column('blade1.tip.y')]));
    near(await read('Hub speed'), Number(row[column('hub.speed')]));
    near(await read('Energy residual'), Number(row[column('energy.residual')]));
    assert.match(await page.locator('#spoken').textContent(), /At 10 s: blades 1–3/);

    const before = await deflection.locator('output').first().textContent();
    const box = await canvas.boundingBox();
    await page.mouse.move(box.x + box.width * 0.3, box.y + box.height / 2);
    assert.notEqual(await deflection.locator('output').first().textContent(), before);
  }));

/** Draws a plot anew and notes the labels at its left: their text, and where they begin. */
const labelsOf = (plot) =>
  plot.locator('canvas').first().evaluate((canvas) => {
    const labels = [];
    const { prototype } = CanvasRenderingContext2D;
    const fillText = prototype.fillText;
    prototype.fillText = function note(text, x, y) {
      if (this.canvas === canvas && this.textAlign === 'right' && this.textBaseline === 'middle')
        labels.push({ text, left: x - this.measureText(text).width });
      fillText.call(this, text, x, y);
    };
    canvas.dispatchEvent(new KeyboardEvent('keydown', { key: '0' }));
    prototype.fillText = fillText;
    return labels;
  });

/** The shipped rotor at a constant speed of its hub [rad/s]; its page. */
function runAtConstantSpeed(speed) {
  const given = readFileSync(join(process.env.SPOKE_MODELS_DIR, 'wu_haug_rotor.toml'), 'utf8');
  const drive = `kind = "table"\ntime = [0.0, 2.0]\nspeed = [${speed}, ${speed}]\n\n[blade]`;
  const text = given.replace(/kind = [^[]*\[blade\]/, drive).replace(/duration = .*/, 'duration = 2.0');
  const file = join(folder, 'constant.toml');
  writeFileSync(file, text);
  execFileSync(process.env.SPOKE_PROGRAM, ['run', file, '--quiet', '--out', join(folder, 'constant')]);
  return join(folder, 'constant', 'report.html');
}

test('a nearly constant curve has labels that are whole, differ and are near its value', () =>
  withPage(runAtConstantSpeed(1.27), {}, async (page) => {
    const labels = await labelsOf(plotOf(page, 'Hub speed'));
    assert.ok(labels.length >= 2, `${labels.length} labels`);
    for (const { text, left } of labels) {
      assert.ok(left >= 2, `${text} begins at ${left}`);
      assert.ok(Math.abs(Number(text) - 1.27) < 1e-3, text);
    }
    assert.equal(new Set(labels.map(({ text }) => text)).size, labels.length);
  }));

test('dragging zooms all plots, double-click and keys reset', () =>
  withPage(rotorPage, {}, async (page) => {
    assert.deepEqual(await shownWindow(page), [0, 20]);
    const canvas = plotOf(page, 'Hub speed').locator('canvas').first();
    const other = plotOf(page, 'Torque').locator('canvas').first();
    const whole = await picture(other);
    await canvas.scrollIntoViewIfNeeded();
    const box = await canvas.boundingBox();
    await page.mouse.move(box.x + box.width * 0.4, box.y + 60);
    await page.mouse.down();
    await page.mouse.move(box.x + box.width * 0.6, box.y + 80, { steps: 5 });
    await page.mouse.up();
    const [begin, end] = await shownWindow(page);
    assert.ok(begin > 5 && end < 14 && end - begin > 3, `${begin} to ${end}`);
    assert.notEqual(await picture(other), whole);
    assert.ok(await page.locator('#plots-reset').isEnabled());
    await page.mouse.dblclick(box.x + box.width * 0.5, box.y + 60);
    assert.deepEqual(await shownWindow(page), [0, 20]);
    assert.ok(await page.locator('#plots-reset').isDisabled());
    await canvas.focus();
    await page.keyboard.press('+');
    const [from, to] = await shownWindow(page);
    assert.ok(Math.abs(to - from - 10) < 0.01, `${from} to ${to}`);
    await page.keyboard.press('0');
    assert.deepEqual(await shownWindow(page), [0, 20]);
  }));

test('a name in the legend hides its curve', () =>
  withPage(rotorPage, {}, async (page) => {
    const plot = plotOf(page, 'Energies');
    const canvas = plot.locator('canvas').first();
    const all = await picture(canvas);
    const key = plot.getByRole('button', { name: /kinetic/ });
    await key.focus();
    await page.keyboard.press('Enter');
    assert.equal(await key.getAttribute('aria-pressed'), 'false');
    assert.notEqual(await picture(canvas), all);
    await key.click();
    assert.equal(await key.getAttribute('aria-pressed'), 'true');
  }));

test('the animation begins where the deflection is largest, plays, pauses and seeks', () =>
  withPage(rotorPage, {}, async (page) => {
    const time = async () => Number((await page.locator('#animation-now').textContent()).split(' ')[0]);
    assert.ok(Math.abs((await time()) - 6.75) < 0.06);
    const play = page.locator('#animation-play');
    assert.equal(await play.textContent(), 'Play');
    await play.focus();
    await page.keyboard.press('Enter');
    assert.equal(await play.textContent(), 'Pause');
    const begin = await time();
    await page.waitForFunction((from) => parseFloat(document.getElementById('animation-now').textContent) > from + 0.1, begin);
    await play.click();
    const still = await time();
    await page.waitForTimeout(150);
    assert.equal(await time(), still);

    const hub = page.locator('#animation-hub');
    await page.locator('#animation-time').fill('0');
    const undeformed = await picture(hub);
    await page.locator('#animation-time').fill('6.75');
    assert.notEqual(await picture(hub), undeformed);
    const canvas = plotOf(page, 'Hub speed').locator('canvas').first();
    const box = await canvas.boundingBox();
    await canvas.click({ position: { x: box.width * 0.8, y: 60 } });
    assert.ok((await time()) > 13);
  }));

test('deflections are exaggerated 1 to 100 times, the outline can go', () =>
  withPage(rotorPage, {}, async (page) => {
    const hub = page.locator('#animation-hub');
    const times = page.locator('#animation-times');
    assert.equal(await times.textContent(), '\u00d7 1');
    const plain = await picture(hub);
    await page.locator('#animation-scale').fill('200');
    assert.equal(await times.textContent(), '\u00d7 100');
    assert.notEqual(await picture(hub), plain);
    await page.locator('#animation-scale').fill('0');
    assert.equal(await picture(hub), plain);
    await page.locator('#animation-outline').uncheck();
    assert.notEqual(await picture(hub), plain);
  }));

test('a free hub has a plot of its place, and small deflections are shown larger', () =>
  withPage(join(run('free_hub_satellite'), 'report.html'), {}, async (page) => {
    assert.equal(await page.locator('.plot').count(), 9);
    assert.equal(await page.locator('#animation-times').textContent(), '\u00d7 10');
  }));

test('a run that diverged shows why and what came before', () => {
  const out = join(folder, 'diverged');
  const model = join(process.env.SPOKE_MODELS_DIR, 'paper_rotor.toml');
  const ended = spawnSync(process.env.SPOKE_PROGRAM, ['run', model, '--quiet', '--out', out, '--set', 'blade.bodies=1']);
  assert.equal(ended.status, 3);
  return withPage(join(out, 'report.html'), {}, async (page) => {
    assert.match(await page.locator('.note.bad').textContent(), /diverged at t = 10/);
    const [begin, end] = await shownWindow(page);
    assert.equal(begin, 0);
    assert.ok(end > 10 && end < 11);
  });
});

test('a run that ends at once has plots and no animation', () => {
  const out = join(folder, 'early');
  const model = join(process.env.SPOKE_MODELS_DIR, 'wu_haug_rotor.toml');
  const options = ['run', model, '--integrator', 'rk4', '--quiet', '--out', out];
  assert.equal(spawnSync(process.env.SPOKE_PROGRAM, options).status, 3);
  return withPage(join(out, 'report.html'), {}, async (page) => {
    assert.equal(await page.locator('.plot').count(), 8);
    assert.equal(await page.locator('#animation-play').count(), 0);
    const canvas = plotOf(page, 'Hub speed').locator('canvas').first();
    await canvas.click({ position: { x: 200, y: 60 } });
  });
});

test('the page of a large model stays small and works', () => {
  const page = join(run('large_rotor', '--set', 'integration.duration=0.5'), 'report.html');
  assert.ok(statSync(page).size < 2.5e6);
  return withPage(page, {}, async (opened) => {
    assert.ok((await countPixels(opened.locator('#animation-hub'))) > 1000);
  });
});

test('a turbine in wind has plots of the air, and the statistics of summary.json', () => {
  const out = run('nrel_5mw_in_wind', '--set', 'integration.duration=2', '--set', 'wind.turbulence.duration=20');
  const { statistics } = JSON.parse(readFileSync(join(out, 'summary.json'), 'utf8'));
  return withPage(join(out, 'report.html'), {}, async (page) => {
    const titles = await page.$$eval('.plot figcaption strong', (found) => found.map((title) => title.textContent));
    for (const title of ['Wind at the hub along the axis', 'Thrust of the air', 'Power of the air', 'Pitch by control', 'Support: root.force.z'])
      assert.ok(titles.includes(title), title);
    assert.match(await plotOf(page, 'Hub speed').textContent(), /speed/);
    const legend = await page.locator('.plot').filter({ has: page.getByText('root.force.z', { exact: true }) }).locator('.legend').textContent();
    assert.ok(legend.includes('blade 1') && !legend.includes('support'), legend);
    const table = page.locator('table').filter({ hasText: 'damage-equivalent range' });
    const rows = await table.locator('tbody tr').evaluateAll((found) =>
      found.map((row) => [...row.querySelectorAll('td')].map((cell) => cell.textContent)));
    assert.deepEqual(rows.map(([name]) => name), Object.keys(statistics.sensors));
    for (const [name, unit, ...numbers] of rows) {
      const of = statistics.sensors[name];
      assert.equal(unit, of.unit);
      const expected = [of.mean, of.standard_deviation, of.min, of.max];
      if ('damage_equivalent_range' in of) expected.push(of.damage_equivalent_range, of.wohler_exponent);
      else assert.deepEqual(numbers.splice(-2), ['', '']);
      assert.deepEqual(numbers.map(Number), expected.map((value) => Number(value.toPrecision(6))), name);
    }
    const overflow = await page.evaluate(() => document.documentElement.scrollWidth - innerWidth);
    assert.ok(overflow <= 0, `wider than the window by ${overflow}`);
  });
});
