import { createServer, type Server } from 'node:http';
import type { AddressInfo } from 'node:net';
import { afterAll, beforeAll, describe, expect, it } from 'vitest';
import { createHttpLibrary, createNodeSandboxes } from '../src/node/index.ts';
import { faultFrom, openSandbox, valuesOf } from '../src/testing/index.ts';
import { WORKER_FILE } from './build-worker.ts';

let server: Server;
const origin = (of: Server): string => `http://127.0.0.1:${(of.address() as AddressInfo).port}`;

beforeAll(async () => {
  server = createServer((request, response) => {
    response.end('{"hello":"ä"}');
  });
  await new Promise<void>((resolve) => server.listen(0, '127.0.0.1', resolve));
});

afterAll(() => {
  server.closeAllConnections();
  server.close();
});

describe.each([
  ['sandboxed', false],
  ['trusted', true],
])('state.modules.http of %s code [PM-52]', (_, isTrusted) => {
  const sandboxes = () =>
    createNodeSandboxes({
      workerFile: WORKER_FILE,
      maxWorkers: 1,
      hostLibraries: { http: createHttpLibrary([origin(server)]) },
    });

  it('is there when it was asked for, and only then', async () => {
    const factory = sandboxes();
    const onProcessing = `async (dt, inputs, state) => {
      const { http } = state.modules;
      if (http === undefined) return { outputs: { out: { string: 'none' } } };
      const { status, text } = await http.get('${origin(server)}/hello');
      return { outputs: { out: { string: status + JSON.parse(text).hello } } };
    }`;
    const without = openSandbox(factory, { onProcessing }, isTrusted);
    await without.sandbox.create();
    expect(valuesOf((await without.run()).outputs)).toEqual({ out: 'none' });
    const withIt = openSandbox(factory, { onProcessing, libraries: ['http'] }, isTrusted);
    await withIt.sandbox.create();
    expect(valuesOf((await withIt.run()).outputs)).toEqual({ out: '200ä' });
    expect(valuesOf((await withIt.run()).outputs)).toEqual({ out: '200ä' });
    await factory.close();
  });

  it('refuses other origins with a sentence, and cannot be made to call anything else', async () => {
    const factory = sandboxes();
    const onProcessing = `async (dt, { }, state) => {
      const { http } = state.modules;
      try { await http.get(${JSON.stringify('http://127.0.0.1:1/')}) } catch (error) { console.log(error.message) }
      try { await http.constructor.constructor('return process')() } catch (error) { console.log('no') }
    }`;
    const { sandbox, run, lines } = openSandbox(
      factory,
      { onProcessing, libraries: ['http'] },
      isTrusted,
    );
    await sandbox.create();
    await run();
    expect(lines[0]).toContain('Reading from http://127.0.0.1:1 is not allowed');
    if (!isTrusted) expect(lines[1]).toBe('log: no');
    await factory.close();
  });

  it('does not let a loop go on after an answer [PM-53]', async () => {
    const factory = sandboxes();
    const onProcessing = `async (dt, inputs, state) => {
      await state.modules.http.get('${origin(server)}/hello');
      for (;;) {}
    }`;
    const { sandbox, run } = openSandbox(factory, { onProcessing, libraries: ['http'] }, isTrusted);
    await sandbox.create();
    expect(await faultFrom(run())).toMatchObject({ kind: 'timeout', phase: 'onProcessing' });
    await factory.close();
  });
});
