import * as tf from '@tensorflow/tfjs-core';

/** Files by name, for example those of an asset set. */
export type Files = Readonly<Record<string, Uint8Array>>;

/** The interface of TensorFlow.js to its environment. */
type Platform = typeof tf.env extends () => { platform: infer P } ? P : never;

/**
 * Makes TensorFlow.js read files from memory instead of the network, in every kind of worker. Files are
 * found by the last segment of their address.
 *
 * @param files the files that can be read
 */
export function useMemoryPlatform(files: Files): void {
  const encoder = new TextEncoder();
  const platform: Platform = {
    fetch: (address) => {
      const name = String(address).split('/').at(-1) ?? '';
      const bytes = files[name];
      // A copy, because `bytes` may be a view of a larger or shared buffer.
      return bytes === undefined
        ? Promise.reject(
            new Error(
              `No file "${name}" was passed to createTensorflow. TensorFlow.js has no network access.`,
            ),
          )
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
