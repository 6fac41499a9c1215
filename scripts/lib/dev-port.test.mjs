import assert from 'node:assert/strict';
import { createServer } from 'node:net';
import { test } from 'node:test';

import { choosePort, freePort } from './dev-port.mjs';

test('the port flag is taken out of the flags, however it is written', async () => {
  for (const flags of [
    ['--port', '9001', '--lan'],
    ['--lan', '--port=9001'],
  ]) {
    assert.equal(await choosePort(flags), 9001);
    assert.deepEqual(flags, ['--lan']);
  }
});

test('any free port is decided at once', async () => {
  assert.ok((await choosePort(['--port', '0'])) > 0);
});

test('a port that is taken gives way to another', async (t) => {
  const server = createServer();
  await new Promise((resolve) => server.listen(0, resolve));
  t.after(() => server.close());
  assert.notEqual(await freePort(server.address().port), server.address().port);
});
