import { createServer } from 'node:http';
import { existsSync, mkdtempSync, rmSync } from 'node:fs';
import type { AddressInfo } from 'node:net';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { afterAll, beforeAll, describe, expect, it } from 'vitest';
import { untrustedSandboxes } from './fixture.ts';

const folder = mkdtempSync(join(tmpdir(), 'ubii-break-out-'));
const target = join(folder, 'written');
const requests: string[] = [];
const server = createServer((request, response) => {
  requests.push(request.url ?? '');
  response.end('secret');
});
let url = '';

beforeAll(async () => {
  await new Promise<void>((resolve) => server.listen(0, '127.0.0.1', resolve));
  url = `http://127.0.0.1:${(server.address() as AddressInfo).port}/`;
  process.env['UBII_BREAK_OUT_SECRET'] = 'secret';
});

afterAll(() => {
  server.close();
  delete process.env['UBII_BREAK_OUT_SECRET'];
  rmSync(folder, { recursive: true });
});

/** Ways to a function that makes code, through everything that is within reach. */
const CONSTRUCTORS = [
  'Function',
  '(() => {}).constructor',
  'state.constructor.constructor',
  'inputs.constructor.constructor',
  'state.modules.constructor.constructor',
  'console.log.constructor',
  'console.constructor.constructor',
  '(async () => {}).constructor',
  '(function* () {}).constructor',
  'Object.getPrototypeOf(async function* () {}).constructor',
  '[].map.constructor',
  'Error().constructor.constructor',
  'Promise.resolve().constructor.constructor',
  'Reflect.get(Symbol, "constructor")',
];

/** Names of all that a host could have left lying about. */
const HOST_NAMES = [
  'process',
  'require',
  'module',
  'global',
  'Buffer',
  'fetch',
  'XMLHttpRequest',
  'WebSocket',
  'setTimeout',
  'setInterval',
  'setImmediate',
  'queueMicrotask',
  'importScripts',
  'postMessage',
  'Worker',
  'MessageChannel',
  'MessagePort',
  'BroadcastChannel',
  'WebAssembly',
  'SharedArrayBuffer',
  'navigator',
  'self',
  'window',
  'document',
  'performance',
  'indexedDB',
  'crypto',
  'structuredClone',
  'std',
  'os',
  'bjson',
  'print',
  'scriptArgs',
  '__filename',
  '__dirname',
  'URL',
  'TextDecoder',
];

describe('sandboxed code reaches [PM-52]', () => {
  const { attempt, create } = untrustedSandboxes();

  it.each(HOST_NAMES)('nothing called %s', async (name) => {
    expect(
      await attempt(`return typeof ${name} + typeof globalThis[${JSON.stringify(name)}]`),
    ).toBe('undefinedundefined');
  });

  it.each(CONSTRUCTORS)('no host through %s', async (path) => {
    const program = `
      const seen = [];
      for (const name of ['process', 'require', 'fetch', 'WebAssembly', 'postMessage']) {
        try {
          const made = (${path})('return typeof ' + name)();
          const type = typeof made === 'string' ? made : made.next ? (await made.next()).value : await made;
          if (type !== 'undefined') seen.push(name + type);
        } catch {}
      }
      return seen.join() || 'nothing'`;
    expect(await attempt(program)).toBe('nothing');
  });

  it('no module', async () => {
    for (const name of [
      'fs',
      'node:fs',
      'module',
      'std',
      'os',
      'file:///etc/passwd',
      'data:text/javascript,export default 1',
    ]) {
      expect(
        await attempt(`return import(${JSON.stringify(name)}).then(() => 'in', () => 'out')`),
      ).toBe('out');
    }
    expect(await attempt('return eval("import.meta")')).toMatchObject({ kind: 'threw' });
  });

  it('no file and no network, whatever it tries', async () => {
    const body = `
      const tries = [
        () => globalThis.process.binding('fs'),
        () => require('fs').writeFileSync(${JSON.stringify(target)}, 'x'),
        () => this.constructor.constructor('return process')().mainModule.require('fs').writeFileSync(${JSON.stringify(target)}, 'x'),
        () => fetch(${JSON.stringify(url)}),
        () => new WebSocket(${JSON.stringify(url)}),
        () => new (console.log.constructor)('return fetch')()(${JSON.stringify(url)}),
      ];
      let count = 0;
      for (const go of tries) { try { await go(); count++ } catch {} }
      return count`;
    expect(await attempt(body)).toBe('0');
    expect(existsSync(target)).toBe(false);
    expect(requests).toEqual([]);
  });

  it('no environment and no other instance', async () => {
    const first = await create({
      onProcessing: `(dt, inputs, state) => { globalThis.shared = 'mine'; Object.prototype.leak = 'mine'; Array.prototype.map = null; state.mine = 1 }`,
    });
    await first.run();
    const body = `return [typeof shared, typeof ({}).leak, typeof [].map, typeof state.mine].join()`;
    expect(await attempt(body)).toBe('undefined,undefined,function,undefined');
    expect(
      await attempt('return JSON.stringify(globalThis) + Object.keys(globalThis)'),
    ).not.toContain('secret');
    first.sandbox.terminate();
  });

  it('no code of ours that gives more than it has', async () => {
    // Whatever is found on the way up the stack is a text; no function of the engine's is callable.
    const body = `
      const found = [];
      Error.prepareStackTrace = (error, frames) => { found.push(...frames.map((frame) => typeof frame)); return '' };
      void new Error().stack;
      const callers = (function () { try { return typeof arguments.callee.caller } catch { return 'no' } })();
      return found.join() + '|' + (callers === 'function' ? 'function' : 'no')`;
    expect(await attempt(body)).not.toContain('function');
  });

  it('no library it did not ask for', async () => {
    expect(await attempt('return Object.keys(state.modules).length')).toBe('0');
    expect(await attempt('state.modules.http = 1; return typeof state.modules.http')).toBe(
      'undefined',
    );
  });
});
