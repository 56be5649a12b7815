// The page that the program writes for the shipped rotor. SPOKE_PROGRAM and SPOKE_SCENARIO name both.
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { mkdtempSync, readFileSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { after, test } from 'node:test';
import { openPage } from './browser.mjs';

const folder = mkdtempSync(join(tmpdir(), 'spoke-rotor-'));
after(() => rmSync(folder, { recursive: true }));

/** Traces the rotor and returns the folder of the files. */
function trace(executor) {
  const out = join(folder, executor);
  execFileSync(process.env.SPOKE_PROGRAM, ['trace', process.env.SPOKE_SCENARIO, '--executor', executor, '--threads', '2', '--out', out]);
  return out;
}

test('the shipped rotor: the page shows what trace.json holds, and compares it with another executor', { timeout: 120000 }, async () => {
  const rotor = trace('flow_graph');
  const serial = trace('serial');
  const { page, problems, close } = await openPage(join(rotor, 'trace.html'));
  try {
    assert.match(await page.textContent('#graphnote'), /61 nodes, 78 edges/);
    await page.click('#scope button:has-text("all steps")');
    const shown = Number(await page.getAttribute('#stagetable tfoot td:nth-child(3)', 'data-value'));
    const { traceEvents } = JSON.parse(readFileSync(join(rotor, 'trace.json'), 'utf8'));
    const slices = traceEvents.filter((event) => event.ph === 'X' && event.cat !== 'step' && event.cat !== 'run');
    const sum = slices.reduce((total, slice) => total + slice.dur, 0);
    assert.ok(slices.length > 61 * 20 && Math.abs(shown - sum) < 1e-3, `${shown} us, not ${sum}`);
    for (const file of ['trace.html', 'trace.json']) {
      await page.setInputFiles('#file', join(serial, file));
      await page.waitForFunction(() => /serial/.test(document.querySelector('#chartname1').textContent));
      await page.click('#remove');
    }
    assert.deepEqual(problems, []);
  } finally {
    await close();
  }
});
