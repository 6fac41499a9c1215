import assert from 'node:assert/strict';
import { spawnSync } from 'node:child_process';
import { test } from 'node:test';

const guard = new URL('./no-processes.mjs', import.meta.url).href;

/** Runs code as a unit test would: in a worker of Vitest. @param {string} code */
function runInWorker(code) {
  const { stdout, stderr } = spawnSync(
    process.execPath,
    ['--import', guard, '--input-type=module', '--eval', code],
    { env: { ...process.env, VITEST_POOL_ID: '1' }, encoding: 'utf8' },
  );
  return stdout + stderr;
}

for (const [deed, code] of [
  ['spawn', "import { spawn } from 'node:child_process'; spawn(process.execPath, ['-v']);"],
  ['fork', "import { fork } from 'node:child_process'; fork('a.js');"],
  [
    'execFile as a promise',
    "import { execFile } from 'node:child_process'; import { promisify } from 'node:util'; await promisify(execFile)('node');",
  ],
  ['execFileSync', "import { execFileSync } from 'node:child_process'; execFileSync('node');"],
  ['a thread', "import { Worker } from 'node:worker_threads'; new Worker('1', { eval: true });"],
  ['an HTTP server', "import { createServer } from 'node:http'; createServer().listen(0);"],
  ['a UDP socket', "import { createSocket } from 'node:dgram'; createSocket('udp4').bind();"],
]) {
  test(`a unit test cannot start ${deed}`, () => {
    assert.match(runInWorker(code), /Error: A unit test .*\*\.process\.test\.ts/);
  });
}

test('a unit test can compile with esbuild', () => {
  const code = "import { transform } from 'esbuild'; console.log((await transform('1 + 1')).code);";
  assert.equal(runInWorker(code).trim(), '1 + 1;');
});
