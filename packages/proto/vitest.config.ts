import { defineConfig } from 'vitest/config';

export default defineConfig({
  test: {
    name: 'proto',
    include: ['src/**/*.test.ts', 'scripts/**/*.test.ts'],
    exclude: ['**/*.process.test.ts'],
    // Tests with random input take seconds on a busy machine; none waits for anything.
    testTimeout: 60_000,
  },
});
