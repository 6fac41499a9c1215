import assert from 'node:assert/strict';
import { test } from 'node:test';

import { launch, run } from './commands.mjs';

test('a command gives its exit code and all it wrote', async () => {
  const script = 'console.log("out"); console.error("err"); process.exitCode = 3';
  const { code, output } = await run(process.execPath, ['-e', script]);
  assert.equal(code, 3);
  assert.match(output, /out/);
  assert.match(output, /err/);
});

test('a command that does not exist is an exit code, too', async () => {
  const { code, output } = await run('ubii-no-such-command', []);
  assert.equal(code, 127);
  assert.match(output, /ubii-no-such-command/);
});

test('a command that is ended gives the code shells give', async () => {
  const started = launch(process.execPath, ['-e', 'setInterval(() => {}, 1000)']);
  started.end('SIGTERM');
  assert.equal((await started.ended).code, 128 + 15);
});
