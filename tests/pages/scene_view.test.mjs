// Models in three dimensions: the page of a run in space, and that of `spoke check --html`, in a
// browser. SPOKE_PROGRAM: the built program; SPOKE_MODELS_DIR: the folder of the shipped scenarios.
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { mkdtempSync, rmSync, statSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { after, test } from 'node:test';

import { openPage, picture } from './browser.mjs';

const folder = mkdtempSync(join(tmpdir(), 'spoke-scene-'));
after(() => rmSync(folder, { recursive: true, force: true }));

const modelOf = (name) => join(process.env.SPOKE_MODELS_DIR, `${name}.toml`);

/** Runs a shipped scenario; its page. */
function run(name, ...options) {
  const out = join(folder, name);
  execFileSync(process.env.SPOKE_PROGRAM, ['run', modelOf(name), '--quiet', '--out', out, ...options]);
  return join(out, 'report.html');
}
/** Draws a shipped scenario; its page. */
function draw(name, ...options) {
  const page = join(folder, `${name}.html`);
  execFileSync(process.env.SPOKE_PROGRAM, ['check', modelOf(name), '--html', page, ...options]);
  return page;
}

async function withPage(file, options, look) {
  const { page, problems, close } = await openPage(file, options);
  try {
    await look(page);
    assert.deepEqual(problems, []);
  } finally {
    await close();
  }
}

/** The box of a canvas's pixels of about a colour [r, g, b], in CSS pixels from its middle; null: none. */
const boxOf = (canvas, color) =>
  canvas.evaluate((element, [r, g, b]) => {
    const { data, width, height } = element.getContext('2d').getImageData(0, 0, element.width, element.height);
    const box = { left: Infinity, right: -Infinity, top: Infinity, bottom: -Infinity, count: 0 };
    const ratio = element.width / element.clientWidth;
    for (let k = 0; k < width * height; ++k) {
      const [pr, pg, pb, pa] = data.subarray(4 * k, 4 * k + 4);
      // Shading changes brightness, not hue.
      const lit = (pr + pg + pb) / (r + g + b);
      const off = Math.abs(pr - lit * r) + Math.abs(pg - lit * g) + Math.abs(pb - lit * b);
      if (pa < 250 || lit < 0.5 || lit > 1.1 || off > 12) continue;
      const [x, y] = [(k % width) / ratio - element.clientWidth / 2, Math.floor(k / width) / ratio - element.clientHeight / 2];
      box.left = Math.min(box.left, x);
      box.right = Math.max(box.right, x);
      box.top = Math.min(box.top, y);
      box.bottom = Math.max(box.bottom, y);
      ++box.count;
    }
    return box.count > 0 ? box : null;
  }, color);

const kBlue = [0, 114, 178]; // of the first blade, light
const kOrange = [213, 94, 0]; // of the second

const satellite = run('satellite_booms', '--set', 'integration.duration=20');

for (const scheme of ['light', 'dark'])
  for (const width of [400, 1280])
    test(`a run in space moves in three dimensions at ${width} pixels, ${scheme}`, () =>
      withPage(satellite, { width, scheme }, async (page) => {
        const views = ['#animation-hub', '#animation-inertial'].map((view) => page.locator(view));
        const before = await Promise.all(views.map(picture));
        await page.locator('#animation-time').fill('12');
        const later = await Promise.all(views.map(picture));
        views.forEach((_, k) => assert.notEqual(later[k], before[k]));
        const overflow = await page.evaluate(() => document.documentElement.scrollWidth - innerWidth);
        assert.ok(overflow <= 0, `wider than the window by ${overflow}`);
      }));

test('dragging turns both views, double-click and buttons turn them back', () =>
  withPage(satellite, {}, async (page) => {
    const [hub, inertial] = [page.locator('#animation-hub'), page.locator('#animation-inertial')];
    const [first, other] = [await picture(hub), await picture(inertial)];
    await hub.scrollIntoViewIfNeeded();
    const box = await hub.boundingBox();
    await page.mouse.move(box.x + 200, box.y + 200);
    await page.mouse.down();
    await page.mouse.move(box.x + 300, box.y + 150, { steps: 4 });
    await page.mouse.up();
    await page.waitForTimeout(50);
    assert.notEqual(await picture(hub), first);
    assert.notEqual(await picture(inertial), other);
    await hub.dblclick();
    await page.waitForTimeout(50);
    assert.equal(await picture(hub), first);
    await page.getByRole('button', { name: 'Top' }).click();
    await page.waitForTimeout(50);
    assert.notEqual(await picture(hub), first);
    await page.getByRole('button', { name: 'Reset view' }).click();
    await page.waitForTimeout(50);
    assert.equal(await picture(hub), first);
  }));

test('keys turn, move and zoom; the wheel scrolls the page until the view has the focus', () =>
  withPage(satellite, {}, async (page) => {
    const hub = page.locator('#animation-hub');
    await hub.scrollIntoViewIfNeeded();
    const first = await picture(hub);
    const box = await hub.boundingBox();
    await page.mouse.move(box.x + 200, box.y + 200);
    await page.mouse.wheel(0, -10);
    await page.waitForTimeout(50);
    assert.equal(await picture(hub), first);
    await hub.focus();
    const seen = new Set([first]);
    for (const key of ['ArrowLeft', 'ArrowUp', 'Shift+ArrowRight', '+', '-']) {
      await page.keyboard.press(key);
      await page.waitForTimeout(50);
      seen.add(await picture(hub));
    }
    assert.ok(seen.size >= 5, `${seen.size} pictures`);
    await page.keyboard.press('0');
    await page.waitForTimeout(50);
    assert.equal(await picture(hub), first);
    await hub.hover();
    await page.mouse.wheel(0, -200);
    await page.waitForTimeout(50);
    assert.notEqual(await picture(hub), first);
  }));

test('colours show the forces that there are, with a scale', () =>
  withPage(satellite, {}, async (page) => {
    const hub = page.locator('#animation-hub');
    const first = await picture(hub);
    assert.ok(await page.locator('#animation-colors').isHidden());
    await page.locator('#animation-color').selectOption('bending');
    assert.match(await page.locator('#animation-colors').textContent(), /^Bending moment: 0 N m[\d.e\u2212]+ N m$/);
    const bending = await picture(hub);
    assert.notEqual(bending, first);
    await page.locator('#animation-color').selectOption('axial');
    assert.match(await page.locator('#animation-colors').textContent(), /tension positive/);
    assert.notEqual(await picture(hub), bending);
    await page.locator('#animation-color').selectOption('tree');
    assert.equal(await picture(hub), first);
  }));

test('a rigid model offers neither forces nor deflections', () =>
  withPage(run('heavy_top'), {}, async (page) => {
    assert.ok(await page.locator('#animation-color').isHidden());
    assert.ok(await page.locator('#animation-scale').isHidden());
    assert.equal(await page.locator('#animation-times').textContent(), '\u00d7 1');
    const inertial = page.locator('#animation-inertial');
    const before = await picture(inertial);
    await page.locator('#animation-time').fill('1');
    assert.notEqual(await picture(inertial), before);
    assert.match(await page.locator('.tiles').textContent(), /Largest tip displacement/);
  }));

test('a model that is drawn before a run is where its scenario says', () => {
  const blades = ['--set', 'blade.count=2', '--set', 'hub.axis=[0,0,1]', '--set', 'blade.precone=0'];
  return withPage(draw('nrel_5mw_rotor', ...blades), {}, async (page) => {
    for (const name of ['axes', 'names']) await page.locator(`#model-${name}`).uncheck();
    const canvas = page.locator('#model-view');
    await page.getByRole('button', { name: 'Top' }).click();
    // From above: the first blade to the right, the second to the left, equally far.
    const [right, left] = [await boxOf(canvas, kBlue), await boxOf(canvas, kOrange)];
    assert.ok(right.left > -20 && left.right < 20, 'on their sides');
    assert.ok(Math.abs(right.right + left.left) < 3, `${right.right} and ${left.left}`);
    await page.getByRole('button', { name: 'Side' }).click();
    const end = await boxOf(canvas, kBlue);
    // Seen from its end: the root's round section.
    const [wide, high] = [end.right - end.left, end.bottom - end.top];
    assert.ok(wide < 0.5 * (right.right - right.left), `${wide} of ${right.right - right.left}`);
    assert.ok(Math.abs(wide - high) < 0.1 * wide, `${wide} and ${high}`);
  });
});

test('joints, axes, loads and names can be shown or not', () =>
  withPage(draw('articulated_rotor'), { scheme: 'dark' }, async (page) => {
    const canvas = page.locator('#model-view');
    const seen = new Set([await picture(canvas)]);
    for (const name of ['axes', 'joints', 'loads', 'names']) {
      await page.locator(`#model-${name}`).uncheck();
      seen.add(await picture(canvas));
    }
    assert.equal(seen.size, 5);
    assert.ok(await page.locator('#model-sensors').isHidden()); // there are none
    assert.match(await page.locator('table').first().textContent(), /blade 4 \/ pitchrevolute/);
    await canvas.focus();
    await page.keyboard.press('ArrowLeft');
    assert.ok(!seen.has(await picture(canvas)));
  }));

test('loops are drawn and listed, and the swashplate has its name', () =>
  withPage(draw('helicopter_rotor'), {}, async (page) => {
    const canvas = page.locator('#model-view');
    const closed = await picture(canvas);
    await page.locator('#model-joints').uncheck();
    assert.notEqual(await picture(canvas), closed);
    assert.match(await page.locator('table').nth(1).textContent(), /blade 4 \/ pitch_linkdistance/);
    const { loops, solids } = await page.evaluate(() => JSON.parse(document.getElementById('model-data').textContent).scene);
    assert.equal(loops.length, 4);
    assert.ok(solids.some(({ name, group }) => name === 'swashplate' && group > 0));
  }));

test('a car on springs moves on its page', () =>
  withPage(run('vehicle', '--set', 'integration.duration=0.5'), {}, async (page) => {
    const view = page.locator('#animation-hub');
    const before = await picture(view);
    await page.locator('#animation-time').fill('0.3');
    assert.notEqual(await picture(view), before);
  }));

test('pages of models are small', () => {
  assert.ok(statSync(draw('wu_haug_rotor')).size < 1.5e5);
  assert.ok(statSync(draw('large_rotor')).size < 5e5);
});
