import { defineConfig } from 'vitest/config';

export default defineConfig({
  test: {
    name: 'recording',
    include: ['src/**/*.test.ts'],
    exclude: ['**/*.process.test.ts'],
    // Tests that cut files and fill channels take seconds on a busy machine; none waits for a time to pass.
    testTimeout: 60_000,
  },
});
