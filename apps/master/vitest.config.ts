import { defineConfig } from 'vitest/config';

export default defineConfig({
  test: {
    name: 'master',
    include: ['src/**/*.test.ts', 'test/**/*.test.ts'],
    // Hundreds of arbitrary frames take seconds on a busy machine; none waits for a time to pass.
    testTimeout: 60_000,
  },
});
