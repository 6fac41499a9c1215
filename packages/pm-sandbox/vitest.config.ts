import { defineConfig } from 'vitest/config';

export default defineConfig({
  test: {
    name: 'pm-sandbox',
    globalSetup: ['test/build-worker.ts'],
    include: ['src/**/*.test.ts', 'test/**/*.test.ts'],
    // Tests that start threads take seconds on a busy machine; none waits for a time to pass.
    testTimeout: 60_000,
  },
});
