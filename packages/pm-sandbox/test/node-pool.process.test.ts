import { execFile } from 'node:child_process';
import { fileURLToPath } from 'node:url';
import { promisify } from 'node:util';
import { afterEach, describe, expect, it } from 'vitest';
import { createNodeSandboxes, type NodeSandboxOptions } from '../src/node/index.ts';
import type { SandboxFactory } from '../src/index.ts';
import {
  faultFrom,
  openSandbox,
  valuesOf,
  type OpenSandbox,
  type SandboxInit,
} from '../src/testing/index.ts';
import { WORKER_FILE } from './build-worker.ts';

const factories: SandboxFactory[] = [];
afterEach(() => Promise.all(factories.splice(0).map((factory) => factory.close())));

/** Trusted instances, all in one worker. */
function trusted(
  options: Partial<NodeSandboxOptions> = {},
): (init: SandboxInit) => Promise<OpenSandbox> {
  const factory = createNodeSandboxes({ workerFile: WORKER_FILE, maxWorkers: 1, ...options });
  factories.push(factory);
  return async (init) => {
    const opened = openSandbox(factory, init, true);
    await opened.sandbox.create();
    return opened;
  };
}

const COUNTER = `(dt, inputs, state) => ({ outputs: { out: { string: String(state.n = (state.n ?? 0) + 1) } } })`;
const LOOP_AT_1 = '(dt) => { while (dt === 1); return { outputs: { out: { string: "x" } } } }';

describe('workers of trusted code in Node', () => {
  it('blame the looping instance, and tell the others that their state is lost [PM-53]', async () => {
    const create = trusted();
    const neighbour = await create({ onProcessing: COUNTER });
    const culprit = await create({ onProcessing: LOOP_AT_1, instanceId: 'culprit' });
    expect(await faultFrom(culprit.run({ deltaTimeMs: 1 }))).toMatchObject({ kind: 'timeout' });
    const fault = await neighbour.killed;
    expect(fault.kind).toBe('crashed');
    expect(fault.message).toContain('lost its state');
  });

  it('give a culprit a worker of its own the next time', async () => {
    const create = trusted();
    const first = await create({ onProcessing: LOOP_AT_1, instanceId: 'culprit' });
    await faultFrom(first.run({ deltaTimeMs: 1 }));
    const neighbour = await create({ onProcessing: COUNTER });
    const second = await create({ onProcessing: LOOP_AT_1, instanceId: 'culprit' });
    await neighbour.run();
    expect(await faultFrom(second.run({ deltaTimeMs: 1 }))).toMatchObject({ kind: 'timeout' });
    expect(valuesOf((await neighbour.run()).outputs)).toEqual({ out: '2' });
  });

  it('may end themselves without harm to the program', async () => {
    const create = trusted();
    const { run, killed } = await create({ onProcessing: '() => process.exit(3)' });
    expect(await faultFrom(run())).toMatchObject({ kind: 'crashed' });
    expect((await killed).message).toContain('code 3');
    const next = await create({ onProcessing: COUNTER });
    expect(valuesOf((await next.run()).outputs)).toEqual({ out: '1' });
  });

  it('go on when a timer of a module throws', async () => {
    const create = trusted();
    const { run, lines } = await create({
      onProcessing:
        '() => new Promise((resolve) => { setTimeout(() => { setImmediate(resolve); throw new Error("late") }) })',
    });
    await run();
    expect(lines).toEqual(['error: Outside of a callback: late']);
  });

  it('know no variable of the environment', async () => {
    const create = trusted();
    const { run } = await create({
      onProcessing: '() => ({ outputs: { out: { string: Object.keys(process.env).join() } } })',
    });
    expect(valuesOf((await run()).outputs)).toEqual({ out: '' });
  });

  it('give libraries of the node to modules that need them [PM-4]', async () => {
    const library = 'data:text/javascript,export default { twice: (x) => 2 * x }';
    const create = trusted({
      libraries: { maths: library, broken: 'data:text/javascript,throw 1' },
    });
    const onProcessing = `(dt, inputs, { modules }) => ({ outputs: { out: { string: String(modules.maths?.twice(21)) } } })`;
    const { run } = await create({ onProcessing, libraries: ['maths'] });
    expect(valuesOf((await run()).outputs)).toEqual({ out: '42' });
    expect(await faultFrom(create({ onProcessing, libraries: ['broken'] }))).toMatchObject({
      kind: 'library',
    });
  });

  it('say where a source does not parse [PM-13]', async () => {
    const onProcessing = '(dt) => {\n  const a = ;\n}';
    expect(await faultFrom(trusted()({ onProcessing }))).toMatchObject({
      kind: 'syntax',
      phase: 'onProcessing',
      line: 2,
      column: 13,
    });
  });

  it('reject pending calls when the node closes, and kill no instance', async () => {
    const create = trusted();
    const { run, killed } = await create({ onProcessing: '() => new Promise(() => {})' });
    const pending = faultFrom(run());
    await factories[0]!.close();
    expect(await pending).toMatchObject({ kind: 'crashed', message: 'The node is closing.' });
    expect(await Promise.race([killed, Promise.resolve('none')])).toBe('none');
  });

  it('do not keep a program alive that has nothing left to do', async () => {
    const program = `
      import { createNodeSandboxes } from ${JSON.stringify(new URL('../src/node/index.ts', import.meta.url).href)};
      const factory = createNodeSandboxes({ workerFile: ${JSON.stringify(WORKER_FILE)} });
      console.log(await factory.check({ onProcessing: '() => {}' }));`;
    const tsx = fileURLToPath(new URL('../../../node_modules/tsx/dist/cli.mjs', import.meta.url));
    const { stdout } = await promisify(execFile)(process.execPath, [
      tsx,
      '--input-type=module',
      '--eval',
      program,
    ]);
    expect(stdout.trim()).toBe('undefined');
  });
});
