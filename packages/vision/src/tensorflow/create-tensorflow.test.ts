import * as tf from '@tensorflow/tfjs-core';
import { beforeAll, describe, expect, it } from 'vitest';
import { readAssetSet } from '../../scripts/asset-sets.mjs';
import { createTensorflow, type Tensorflow, WASM_FILE } from './create-tensorflow.ts';
import { knownResults, probeError, runProbe } from './probe.ts';

let wasm: Tensorflow;
let cpu: Tensorflow;
beforeAll(async () => {
  wasm = await createTensorflow(readAssetSet('tfjs-wasm'));
  cpu = await createTensorflow({}, { backend: 'wasm' });
});

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

  it('falls back to plain JavaScript without the wasm file', () => {
    expect(cpu.backend).toBe('cpu');
    expect(cpu.reason).toBe(
      `cpu instead of wasm: The file "${WASM_FILE}" was not passed to createTensorflow.`,
    );
  });

  it('starts wasm from memory, checked and measured', () => {
    const { backend, trials } = wasm;
    expect(backend).toBe('wasm');
    expect(trials.map(({ name, outcome }) => [name, outcome])).toEqual([
      ['webgpu', 'absent'],
      ['webgl', 'absent'],
      ['wasm', 'chosen'],
      ['cpu', 'not tried'],
    ]);
    expect(trials[2]!.probeMs).toBeGreaterThan(0);
  });

  it('has no network access', async () => {
    await expect(tf.env().platform.fetch('https://example.com/model.json')).rejects.toThrow(
      'No file "model.json" was passed to createTensorflow. TensorFlow.js has no network access.',
    );
  });

  it('runs tasks of instances with different backends one after the other', async () => {
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
    const { run } = wasm;
    await expect(run(() => Promise.reject(new Error('no picture')))).rejects.toThrow('no picture');
    expect(await run(() => 1)).toBe(1);
  });
});

describe('the probe', () => {
  it('gives the known results on both backends', async () => {
    expect(probeError(await wasm.run(runProbe), knownResults())).toBe(0);
    expect(probeError(await cpu.run(runProbe), knownResults())).toBe(0);
  });

  it('finds wrong and missing numbers', async () => {
    const numbers = await wasm.run(runProbe);
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
