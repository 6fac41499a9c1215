import * as tf from '@tensorflow/tfjs-core';
import { describe, expect, it } from 'vitest';
import { readAssetSet } from '../../scripts/asset-sets.mjs';
import { createTensorflow, WASM_FILE } from './create-tensorflow.ts';
import { knownResults, probeError, runProbe } from './probe.ts';

describe('createTensorflow', () => {
  it('falls back to plain JavaScript when the wasm file is damaged, with the reason', async () => {
    const damaged = readAssetSet('tfjs-wasm')[WASM_FILE]!.slice(0, 1000);
    const { backend, trials } = await createTensorflow({ [WASM_FILE]: damaged });
    expect(backend).toBe('cpu');
    expect(trials.find(({ name }) => name === 'wasm')).toMatchObject({
      outcome: 'failed',
      reason: `The file "${WASM_FILE}" is damaged, or WebAssembly SIMD is missing here.`,
    });
  });

  it('falls back to plain JavaScript without the wasm file', async () => {
    const { backend, reason } = await createTensorflow({}, { backend: 'wasm' });
    expect(backend).toBe('cpu');
    expect(reason).toBe(`cpu instead of wasm: The file "${WASM_FILE}" was not handed in.`);
  });

  it('starts wasm from memory, checked and measured', async () => {
    const { backend, trials } = await createTensorflow(readAssetSet('tfjs-wasm'));
    expect(backend).toBe('wasm');
    expect(trials.map(({ name, outcome }) => [name, outcome])).toEqual([
      ['webgpu', 'absent'],
      ['webgl', 'absent'],
      ['wasm', 'chosen'],
      ['cpu', 'not tried'],
    ]);
    expect(trials[2]!.probeMs).toBeGreaterThan(0);
  });

  it('asks no network', async () => {
    await createTensorflow(readAssetSet('tfjs-wasm'));
    await expect(tf.env().platform.fetch('https://example.com/model.json')).rejects.toThrow(
      'No file "model.json" was handed in. The network is not asked.',
    );
  });

  it('runs tasks of instances with different backends one after the other', async () => {
    const wasm = await createTensorflow(readAssetSet('tfjs-wasm'));
    const cpu = await createTensorflow(readAssetSet('tfjs-wasm'), { backend: 'cpu' });
    const seen: string[] = [];
    const task = async () => {
      seen.push(tf.getBackend());
      await Promise.resolve();
      seen.push(tf.getBackend());
    };
    await Promise.all([wasm.run(task), cpu.run(task), wasm.run(task)]);
    expect(seen).toEqual(['wasm', 'wasm', 'cpu', 'cpu', 'wasm', 'wasm']);
  });

  it('goes on after a task that fails', async () => {
    const { run } = await createTensorflow(readAssetSet('tfjs-wasm'));
    await expect(run(() => Promise.reject(new Error('no picture')))).rejects.toThrow('no picture');
    expect(await run(() => 1)).toBe(1);
  });
});

describe('the probe', () => {
  it.each(['wasm', 'cpu'] as const)('gives the known results on %s', async (backend) => {
    const { run } = await createTensorflow(readAssetSet('tfjs-wasm'), { backend });
    expect(probeError(await run(runProbe), knownResults())).toBe(0);
  });

  it('finds wrong and missing numbers', async () => {
    const { run } = await createTensorflow(readAssetSet('tfjs-wasm'));
    const numbers = await run(runProbe);
    const known = knownResults();
    const { index } = known.find(({ value }) => value !== 0)!;
    expect(probeError(numbers.with(index, NaN), known)).toBe(Infinity);
    expect(
      probeError(
        numbers.map((value) => value * 1.5),
        known,
      ),
    ).toBeCloseTo(0.5);
    expect(probeError(new Float32Array(), known)).toBe(Infinity);
  });
});
