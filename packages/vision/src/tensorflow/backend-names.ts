/** Backends of TensorFlow.js: graphics card (two APIs), WebAssembly, plain JavaScript. */
export const BACKEND_NAMES = ['webgpu', 'webgl', 'wasm', 'cpu'] as const;

export type BackendName = (typeof BACKEND_NAMES)[number];

/** Choices of callers: the fastest backend, or one by name. */
export const BACKEND_CHOICES = ['auto', ...BACKEND_NAMES] as const;
