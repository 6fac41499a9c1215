import { defineConfig } from 'vitest/config';

export default defineConfig({
  test: {
    name: 'vision',
    include: ['src/**/*.test.ts', 'test/**/*.test.ts'],
    // Inference of real models takes seconds on a busy machine; no test waits for a time to pass.
    testTimeout: 60_000,
    hookTimeout: 60_000,
  },
});
