import { expect, it } from 'vitest';
import { backendWords, gpuName } from './backend-words.ts';

it.each([
  ['ANGLE (NVIDIA, NVIDIA GeForce RTX 3060 Direct3D11 vs_5_0 ps_5_0, D3D11)', 'GeForce RTX 3060'],
  ['ANGLE (Apple, ANGLE Metal Renderer: Apple M2, Unspecified Version)', 'Apple M2'],
  [
    'ANGLE (Intel, Mesa Intel(R) UHD Graphics 620 (KBL GT2), OpenGL 4.6)',
    'Mesa Intel UHD Graphics 620',
  ],
  ['Adreno (TM) 650', 'Adreno 650'],
  ['Apple GPU', 'Apple GPU'],
  ['', undefined],
])('%s is called %s', (renderer, name) => {
  expect(gpuName(renderer)).toBe(name);
});

it('names the graphics card only where it computes', () => {
  expect(backendWords('webgl', 'Apple M2')).toBe('WebGL, Apple M2');
  expect(backendWords('wasm', 'Apple M2')).toBe('WebAssembly');
  expect(backendWords('webgpu', undefined)).toBe('WebGPU');
});
