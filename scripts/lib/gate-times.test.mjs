import assert from 'node:assert/strict';
import { test } from 'node:test';

import { readGateRun, tableOfRuns } from './gate-times.mjs';

const OUTPUT = `
  install packages (pnpm 10.34.9) ............. 4.8 s
  types of @ubii/bridge ....................... 2.2 s
Running 27 tests using 2 workers
  1 flaky
    [chromium] › tests/graph/life.spec.ts:11:1 › files that are none are named ───
  26 passed (1.5m)

26 passed, 0 failed
  unit tests .................................. 204.0 s
  300 passed (10.0m)
11386 passed, 0 failed
`;

test('steps, stories, what was flaky and the counts are read from what a run wrote', () => {
  const run = readGateRun(OUTPUT);
  assert.deepEqual(
    [...run.seconds],
    [
      ['install packages (pnpm 10.34.9)', 4.8],
      ['types of @ubii/bridge', 2.2],
      ['stories, part 1', 90],
      ['unit tests', 204],
      ['stories, part 2', 600],
    ],
  );
  assert.deepEqual(run.flaky, ['tests/graph/life.spec.ts:11:1 › files that are none are named']);
  assert.equal(run.result, '11386 passed, 0 failed');
});

test('runs stand side by side, in minutes', () => {
  const run = readGateRun(OUTPUT);
  const table = tableOfRuns([
    { ...run, total: 900, code: 0 },
    { ...run, flaky: [], total: 840, code: 1 },
  ]);
  assert.match(table, /\| unit tests \| 3\.4 \| 3\.4 \|/);
  assert.match(table, /\| \*\*the whole\*\* \| \*\*15\.0\*\* \| \*\*14\.0\*\* \|/);
  assert.match(table, /\| result \| 11386 passed, 0 failed \| ended with 1 \|/);
  assert.match(table, /\| flaky \| tests\/graph\/life.* \| nothing \|/);
});
