import * as tf from '@tensorflow/tfjs-core';

/** Files by name, for example the assets that a host hands in. */
export type Files = Readonly<Record<string, Uint8Array>>;

/** What TensorFlow.js asks of the program around it. */
type Platform = typeof tf.env extends () => { platform: infer P } ? P : never;

/**
 * Makes TensorFlow.js read from memory instead of the network, in every kind of worker: it gets files
 * that were handed in, by the last part of their address, and nothing else.
 *
 * @param files what can be read
 */
export function useMemoryPlatform(files: Files): void {
  const encoder = new TextEncoder();
  const platform: Platform = {
    fetch: (address) => {
      const name = String(address).split('/').at(-1) ?? '';
      const bytes = files[name];
      // A copy: the answer owns its buffer, while `bytes` may be a view of a larger or shared one.
      return bytes === undefined
        ? Promise.reject(new Error(`No file "${name}" was handed in. The network is not asked.`))
        : Promise.resolve(new Response(bytes.slice()));
    },
    now: () => performance.now(),
    encode: (text) => encoder.encode(text),
    decode: (bytes, encoding) => new TextDecoder(encoding).decode(bytes),
    setTimeoutCustom: (call, delayMs) => setTimeout(call, delayMs),
    isTypedArray: (value): value is Float32Array | Int32Array | Uint8Array | Uint8ClampedArray =>
      value instanceof Float32Array ||
      value instanceof Int32Array ||
      value instanceof Uint8Array ||
      value instanceof Uint8ClampedArray,
  };
  // Not by setPlatform, which warns about each change.
  Object.assign(tf.env(), { platformName: 'memory', platform });
}
