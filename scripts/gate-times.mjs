import { spawn } from 'node:child_process';
import { mkdtempSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { parseArgs } from 'node:util';

import { readGateRun, tableOfRuns } from './lib/gate-times.mjs';
import { run } from './lib/commands.mjs';
import { root } from './lib/repository.mjs';
import { expectSuccess, runScript } from './lib/steps.mjs';

/**
 * Runs the gate in fresh clones of the last commit, one after the other, and writes minutes by step and what was flaky, as
 * Markdown. What a run wrote stays beside the clone until the next start of the machine.
 */
const { values } = parseArgs({
  options: {
    runs: { type: 'string', default: '3' },
    // `npm test` alone instead of all that CI runs
    quick: { type: 'boolean', default: false },
  },
});
const command = values.quick ? ['npm', 'test'] : ['.ci/run'];

await runScript(async () => {
  const runs = [];
  for (let index = 1; index <= Number(values.runs); index++) {
    const folder = mkdtempSync(join(tmpdir(), 'ubii-gate-'));
    const clone = join(folder, 'clone');
    expectSuccess(await run('git', ['clone', '--quiet', root, clone]));
    const begun = performance.now();
    const { code, output } = await runIn(clone);
    const total = (performance.now() - begun) / 1000;
    const log = join(folder, 'output.log');
    writeFileSync(log, output);
    rmSync(clone, { recursive: true, force: true });
    process.stderr.write(`  run ${index}: ${(total / 60).toFixed(1)} minutes, ${log}\n`);
    runs.push({ ...readGateRun(output), total, code });
  }
  process.stdout.write(`\n${tableOfRuns(runs)}\n`);
});

/** @param {string} cwd @returns {Promise<{ code: number, output: string }>} both streams, in the order in which they came */
function runIn(cwd) {
  const [program = '', ...args] = command;
  const child = spawn(program, args, {
    cwd,
    env: { ...process.env, CI: 'true' },
    stdio: ['ignore', 'pipe', 'pipe'],
  });
  let output = '';
  const take = (/** @type {Buffer} */ chunk) => {
    output += chunk.toString('utf8');
  };
  child.stdout.on('data', take);
  child.stderr.on('data', take);
  return new Promise((resolve, reject) => {
    child.once('error', reject);
    child.once('close', (code) => resolve({ code: code ?? 1, output }));
  });
}
