// The page of a study, study.html, in a browser. SPOKE_PROGRAM: the built program; SPOKE_MODELS_DIR:
// the folder of the shipped scenarios.
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { after, test } from 'node:test';

import { openPage } from './browser.mjs';

const folder = mkdtempSync(join(tmpdir(), 'spoke-study-'));
after(() => rmSync(folder, { recursive: true, force: true }));

/** Runs a study of the shipped rotor's first tenth of a second; the folder of its results. */
function runStudy(name, lines) {
  const scenario = readFileSync(join(process.env.SPOKE_MODELS_DIR, 'wu_haug_rotor.toml'), 'utf8');
  const short = scenario.replace(/duration = .*/, 'duration = 0.1');
  // At this step one iteration is too few.
  writeFileSync(join(folder, 'rotor.toml'), short.replace(/step = .*/, 'step = 0.02'));
  const file = join(folder, `${name}.toml`);
  writeFileSync(file, `scenario = "rotor.toml"\n${lines}
[[response]]
sensor = "blade1.tip.y"
kind = "min"
[[response]]
sensor = "hub.torque"
kind = "max"
`);
  const out = join(folder, name);
  execFileSync(process.env.SPOKE_PROGRAM, ['study', file, '--quiet', '--out', out]);
  return out;
}

const out = runStudy('grid', `design = { kind = "grid" }
[[parameter]]
key = "blade.length"
range = [6, 10, 5]
[[parameter]]
key = "blade.reference_frame"
values = ["clamped", "chord"]
[[parameter]]
key = "integration.max_iterations"
values = [30, 1]
`);
const pageFile = join(out, 'study.html');

/** Opens a page, hands it over, and demands that nothing went wrong meanwhile. */
async function withPage(options, look) {
  const { page, problems, close } = await openPage(pageFile, options);
  try {
    await look(page);
    assert.deepEqual(problems, []);
  } finally {
    await close();
  }
}

const selected = (page) => page.locator('#runs-selected').textContent();

/** Number of pixels of a canvas that are not transparent. */
const countPixels = (canvas) =>
  canvas.evaluate((element) => {
    const { data } = element.getContext('2d').getImageData(0, 0, element.width, element.height);
    let count = 0;
    for (let k = 3; k < data.length; k += 4) count += data[k] > 0;
    return count;
  });

for (const scheme of ['light', 'dark'])
  for (const width of [400, 1280])
    test(`the study's page is drawn at ${width} pixels, ${scheme}`, () =>
      withPage({ width, scheme }, async (page) => {
        assert.equal(await selected(page), '20 of 20 runs');
        await page.waitForTimeout(100);
        for (const canvas of ['#parallel', '#scatter'])
          assert.ok((await countPixels(page.locator(canvas))) > 1000, canvas);
        const overflow = await page.evaluate(() => document.documentElement.scrollWidth - innerWidth);
        assert.ok(overflow <= 0, `wider than the window by ${overflow}`);
        assert.match(await page.locator('main').textContent(), /Runs without result/);
        // Where five axes have no room beside one another, their plot is scrolled, also by keys.
        const plot = page.locator('.scroll:has(#parallel)');
        const hidden = await plot.evaluate((frame) => frame.scrollWidth - frame.clientWidth);
        assert.equal(hidden > 0, width === 400);
        assert.ok((await page.locator('#parallel').evaluate((canvas) => canvas.clientWidth)) >= 2 * 75 + 4 * 64);
        await page.locator('#parallel').focus();
        for (let k = 0; k < 4; ++k) await page.keyboard.press('ArrowRight');
        assert.equal((await plot.evaluate((frame) => frame.scrollLeft)) > 0, width === 400);
      }));

test('an axis of one choice has its name at both ends', () => {
  const source = readFileSync(new URL('../../program/report/run_table.js', import.meta.url), 'utf8');
  const Column = new Function(`${source}; return Column;`)();
  const column = new Column({ name: 'case', values: [0, 0], choices: ['NTM'] });
  assert.deepEqual([column.text(column.low), column.text(column.high)], ['NTM', 'NTM']);
});

test('brushes of an axis and of points select runs in both drawings, and are dropped', () =>
  withPage({}, async (page) => {
    const box = await page.locator('#parallel').boundingBox();
    // The first axis is that of the length: its upper 3 of 5 values.
    await page.mouse.move(box.x + 75, box.y + 40);
    await page.mouse.down();
    await page.mouse.move(box.x + 75, box.y + 0.6 * box.height, { steps: 4 });
    await page.mouse.up();
    assert.equal(await selected(page), '12 of 20 runs');
    await page.mouse.click(box.x + 75, box.y + 100);
    assert.equal(await selected(page), '20 of 20 runs');
    await page.locator('#scatter').scrollIntoViewIfNeeded();
    const points = await page.locator('#scatter').boundingBox();
    await page.mouse.move(points.x + 80, points.y + 14);
    await page.mouse.down();
    await page.mouse.move(points.x + 0.5 * points.width, points.y + points.height - 50, { steps: 4 });
    await page.mouse.up();
    const count = Number((await selected(page)).split(' ')[0]);
    assert.ok(count > 0 && count < 10, `${count} runs`);  // of those that have the response
    await page.locator('#runs-clear').click();
    assert.equal(await selected(page), '20 of 20 runs');
    assert.ok(await page.locator('#runs-clear').isDisabled());
  }));

test('axes are brushed from the keyboard, and what was done is said', () =>
  withPage({}, async (page) => {
    await page.locator('#parallel').focus();
    await page.keyboard.press('ArrowRight');
    await page.keyboard.press('Enter'); // the upper half of the frames
    assert.equal(await selected(page), '10 of 20 runs');
    assert.match(await page.locator('#spoken').textContent(), /blade.reference_frame: chord to chord, 10 of 20 runs/);
    await page.keyboard.press('0');
    assert.equal(await selected(page), '20 of 20 runs');
  }));

test('a chosen run shows its values, and the command that makes it again', () =>
  withPage({}, async (page) => {
    await page.locator('#scatter').focus();
    await page.keyboard.press('ArrowRight');
    assert.match(await page.locator('#run-values').textContent(), /^Run 1: blade.length 6, blade.reference_frame clamped/);
    const command = await page.locator('#run-replay').textContent();
    assert.match(command, /^spoke run \S*rotor.toml --set blade.length=6 --set 'blade.reference_frame="clamped"' --set integration.max_iterations=30$/);
    const row = JSON.parse(readFileSync(join(out, 'study.json'), 'utf8')).responses[0];
    assert.ok(row.min.replay.includes('--set blade.length='));
    await page.locator('#scatter-y').selectOption({ label: 'hub.torque.max [N m]' });
    await page.locator('#colors').selectOption({ label: 'blade.length' });
    assert.ok((await countPixels(page.locator('#scatter'))) > 1000);
  }));
