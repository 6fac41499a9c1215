import { defineConfig } from 'vitest/config';

export default defineConfig({
  test: {
    name: 'vision',
    // TensorFlow.js is loaded once for several files; tests compare numbers of tensors with those at their start.
    isolate: false,
    include: ['src/**/*.test.ts', 'test/**/*.test.ts'],
    exclude: ['**/*.process.test.ts'],
    // Inference of real models takes seconds on a busy machine; no test waits for a time to pass.
    testTimeout: 60_000,
    hookTimeout: 60_000,
  },
});
