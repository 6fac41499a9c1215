import type { Sandbox, SandboxFactory } from '@ubii/pm-sandbox';
import { createInlineSandboxes } from '@ubii/pm-sandbox/testing';
import {
  decodeRecord,
  encodeRecord,
  parseDataFormat,
  type DataFormat,
  type JsonObject,
  type RecordInit,
} from '@ubii/proto';
import { describe, expect, it } from 'vitest';

import { classModule } from './class-module.ts';
import { withThreeParameters } from './four-parameters.ts';

const sandboxes = createInlineSandboxes();

/** An instance of a module, with what it put out. */
async function start(module: JsonObject, factory: SandboxFactory = sandboxes) {
  const outputs = module['outputs'] as { internalName: string; messageFormat: string }[];
  const sandbox: Sandbox = factory.open(
    {
      instanceId: 'i',
      moduleName: 'm',
      source: {
        onCreated: module['onCreatedStringified'] as string | undefined,
        onProcessing: module['onProcessingStringified'] as string,
        onHalted: module['onHaltedStringified'] as string | undefined,
      },
      isTrusted: false,
      libraries: [],
      assets: [],
      inputs: ['in'],
      outputs: outputs.map(({ internalName, messageFormat }) => ({
        name: internalName,
        format: parseDataFormat(messageFormat),
      })),
      limits: { callTimeoutMs: 500, memoryBytes: 1e8, outputBytes: 1e6 },
      owner: 'o',
    },
    { onLog: () => undefined, onKilled: () => undefined },
  );
  await sandbox.create();
  const run = async (format: DataFormat, value: unknown): Promise<unknown> => {
    const bytes = encodeRecord({ topic: '/in', format, value } as RecordInit);
    const { outputs: put, faults } = await sandbox.run({
      deltaTimeMs: 1,
      inputs: [{ name: 'in', record: { bytes } }],
    });
    expect(faults).toEqual([]);
    return Object.fromEntries(
      put.map((each) => [
        each.name,
        'value' in each
          ? decodeRecord(each.value.bytes).value
          : each.elements.map(({ value, params }) => [params, decodeRecord(value.bytes).value]),
      ]),
    );
  };
  return { run, sandbox };
}

const io = {
  inputs: [{ internalName: 'in', messageFormat: 'double' }],
  outputs: [{ internalName: 'out', messageFormat: 'double' }],
};

describe('callbacks with four parameters [SE-29]', () => {
  it.each([
    '(deltaTime, inputs, outputs, state) => { outputs.out = 2 * inputs.in; }',
    'function processing(deltaTime, inputs, outputs, state) { outputs.out = 2 * inputs.in; }',
    'async (deltaTime, inputs, outputs, state) => {\n  outputs.out = 2 * inputs.in; // twice\n}',
    '(deltaTime, inputs, outputs, state) => { outputs.out = { double: 2 * inputs.in }; }',
  ])('get and give bare values: %s', async (onProcessingStringified) => {
    const { run } = await start(withThreeParameters({ ...io, onProcessingStringified }));
    expect(await run('double', 4)).toEqual({ out: 8 });
    expect(await run('double', 0)).toEqual({ out: 0 });
  });

  it('keep their state, and publish to topics of a demuxer', async () => {
    const { run } = await start(
      withThreeParameters({
        ...io,
        onProcessingStringified: `(deltaTime, inputs, outputs, state) => {
          state.sum = (state.sum || 0) + inputs.in;
          outputs.out = { elements: [{ double: state.sum, outputTopicParams: ['a'] }] };
        }`,
      }),
    );
    await run('double', 1);
    expect(await run('double', 2)).toEqual({ out: [[['a'], 3]] });
  });

  it.each([
    ['spaces', ' '],
    ['a name', 'x'],
    ['lines', '\n'],
    ['parentheses', '('],
    ['functions', 'function '],
  ])('are looked for once in a text of 4 MiB with %s', (_name, piece) => {
    // What takes the square of the time does not come back from this.
    const filling = piece.repeat((4 * 1024 * 1024) / piece.length);
    for (const start of ['', 'async ', 'async function ', '(']) {
      const module = { ...io, onProcessingStringified: `${start}${filling}` };
      expect(withThreeParameters(module)).toBe(module);
    }
  });

  it('are found behind long gaps', () => {
    const gap = ' \n'.repeat(100_000);
    const text = `${gap}async${gap}function${gap}run${gap}(a,${gap}b, c, d) {}`;
    const { onProcessingStringified } = withThreeParameters({
      ...io,
      onProcessingStringified: text,
    });
    expect(onProcessingStringified).not.toBe(text);
  });

  it('are the only ones that change', () => {
    const module = { ...io, onProcessingStringified: '(deltaTime, inputs, state) => ({})' };
    expect(withThreeParameters(module)).toBe(module);
    expect(withThreeParameters({ name: 'x' })).toEqual({ name: 'x' });
  });
});

describe('a class of the original [SE-29]', () => {
  const written = (body: string) => `
    const { ProcessingModule } = require('@tum-far/ubii-node-nodejs');
    let made = 0;
    module.exports = class extends ProcessingModule {
      constructor(specs) { super(specs); Object.assign(this, ${JSON.stringify({ name: 'm', ...io })}); made++; }
      ${body}
    };`;

  it('is one object for all callbacks, with the state of the instance', async () => {
    const module = await classModule(
      written(`
        onCreated() { this.seen = []; this.state.factor = 10; }
        onProcessing(deltaTime, inputs, state) {
          this.seen.push(inputs.in.double);
          return { outputs: { out: { double: this.seen.length * state.factor + made } } };
        }
        onHalted() { if (this.seen.length !== 2) throw new Error('another object'); }`),
      sandboxes,
    );
    const { run, sandbox } = await start(module);
    expect(await run('double', 5)).toEqual({ out: 11 });
    expect(await run('double', 5)).toEqual({ out: 21 });
    await sandbox.halt();
  });

  it('may replace its state, and have methods with four parameters', async () => {
    const module = await classModule(
      written(`async onProcessing(deltaTime, inputs, outputs, state) {
        this.state = { count: (state.count || 0) + 1 };
        outputs.out = this.state.count + inputs.in;
      }`),
      sandboxes,
    );
    const { run } = await start(module);
    expect(await run('double', 10)).toEqual({ out: 11 });
    expect(await run('double', 10)).toEqual({ out: 12 });
  });

  it('tells the line of what is wrong in it', async () => {
    const text = "\n\nmodule.exports = class {\n  constructor() { throw new Error('no luck'); }\n}";
    await expect(classModule(text, sandboxes)).rejects.toThrow(/no luck.*line 4/);
  });
});
