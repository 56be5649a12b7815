// Solids on pages, in a browser: runs, models before a run, equilibria and modes. SPOKE_PROGRAM: the
// built program; SPOKE_MODELS_DIR: the folder of the shipped scenarios.
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { mkdtempSync, rmSync, statSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { after, test } from 'node:test';

import { picture, withStillPage } from './browser.mjs';

const folder = mkdtempSync(join(tmpdir(), 'spoke-solids-'));
after(() => rmSync(folder, { recursive: true, force: true }));

const bracket = join(process.env.SPOKE_MODELS_DIR, 'solid_bracket.toml');

function spoke(...args) {
  execFileSync(process.env.SPOKE_PROGRAM, args, { stdio: 'pipe' });
}
const out = (name) => join(folder, name);
spoke('run', bracket, '--quiet', '--out', out('run'), '--set', 'integration.duration=0.05');
spoke('check', bracket, '--html', out('model.html'));
spoke('static', bracket, '--out', out('static'));
spoke('modes', bracket, '--out', out('modes'), '--count', '3');

for (const scheme of ['light', 'dark'])
  test(`the bracket of a run moves and is coloured, ${scheme}`, () =>
    withStillPage(join(out('run'), 'report.html'), { scheme }, async (page) => {
      const view = page.locator('#animation-hub');
      const first = await picture(view);
      const seen = new Set([first]);
      for (const [kind, legend] of [['displacement', /^Displacement: 0 m[\d.e\u2212]+ m$/], ['von_mises', /^Von Mises stress: 0 MPa[\d.e\u2212]+ MPa$/]]) {
        await page.locator('#animation-color').selectOption(kind);
        assert.match(await page.locator('#animation-colors').textContent(), legend);
        seen.add(await picture(view));
      }
      await page.locator('#animation-time').fill('0');
      seen.add(await picture(view));
      assert.equal(seen.size, 4);
    }));

test('drawn nodes move by shapes and coordinates, and their stress is linear in these', () =>
  withStillPage(join(out('run'), 'report.html'), {}, async (page) => {
    const found = await page.evaluate(() => {
      const data = JSON.parse(document.getElementById('run-data').textContent);
      const script = document.querySelector('script[type=module]').textContent;
      const { Scene, Deformed, turn } = new Function(`${script}\nreturn { Scene, Deformed, turn };`)();
      const scene = new Scene(data.scene);
      const [mesh] = scene.meshes;
      const surface = scene.surfaces[mesh.surface];
      const unit = surface.stateOf(Float64Array.from({ length: surface.frameSize }, (_, k) => (k === 0 ? 1 : 0)));
      const double = surface.stateOf(Float64Array.from({ length: surface.frameSize }, (_, k) => (k === 0 ? -2 : 0)));
      const state = { ...scene.stateAtRest(), solids: scene.solidsOf([Float64Array.from({ length: surface.frameSize }, (_, k) => (k === 0 ? 1e-3 : 0))]) };
      const [still, moved] = [scene.stateAtRest(), state].map((s) => new Deformed(scene, s, 1).meshPlaces(0));
      let off = 0;
      for (let k = 0; k < still.length; k += 3) {
        const u = turn(mesh.axes, [0, 1, 2].map((c) => 1e-3 * unit.u[k + c]));
        for (let c = 0; c < 3; ++c) off = Math.max(off, Math.abs(moved[k + c] - still[k + c] - u[c]));
      }
      const [a, b] = [unit.vonMises(), double.vonMises()];
      return { off, nodes: surface.nodeCount, most: Math.max(...a), ratio: Math.max(...b) / Math.max(...a), interfaces: mesh.interfaces.map(({ name }) => name) };
    });
    assert.ok(found.off < 1e-9, `${found.off}`);
    assert.ok(found.nodes > 100 && found.nodes <= 1500, `${found.nodes} nodes`);
    assert.ok(found.most > 0);
    assert.ok(Math.abs(found.ratio - 2) < 1e-6);
    assert.deepEqual(found.interfaces, ['root', 'tip']);
  }));

test('a solid is drawn before a run, with the names of its interfaces', () =>
  withStillPage(out('model.html'), {}, async (page) => {
    const canvas = page.locator('#model-view');
    const seen = new Set([await picture(canvas)]);
    for (const name of ['joints', 'names']) {
      await page.locator(`#model-${name}`).uncheck();
      seen.add(await picture(canvas));
    }
    assert.equal(seen.size, 3);
  }));

test('the solid of an equilibrium is coloured', () =>
  withStillPage(join(out('static'), 'static.html'), {}, async (page) => {
    const canvas = page.locator('#steady-view');
    const before = await picture(canvas);
    await page.locator('#steady-color').selectOption('von_mises');
    assert.match(await page.locator('#steady-colors').textContent(), /^Von Mises stress: 0 MPa/);
    const coloured = await picture(canvas);
    assert.notEqual(coloured, before);
    await page.locator('#steady-scale').fill('150');
    assert.notEqual(await picture(canvas), coloured);
  }));

test('a mode moves the solid', () =>
  withStillPage(join(out('modes'), 'modes.html'), {}, async (page) => {
    const view = page.locator('#mode-view');
    const still = await picture(view);
    await page.locator('#mode-amplitude').fill('30');
    assert.notEqual(await picture(view), still);
  }));

test('pages of solids are small', () => {
  assert.ok(statSync(join(out('run'), 'report.html')).size < 1.5e6);
  assert.ok(statSync(out('model.html')).size < 1.2e6);
});
