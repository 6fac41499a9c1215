import { defineConfig } from 'vitest/config';

export default defineConfig({
  test: {
    name: 'robustness',
    include: ['src/**/*.test.ts'],
    globalSetup: 'src/master/build-for-tests.ts',
    // Each starts masters; a busy machine takes its time, and nothing here asserts on it.
    testTimeout: 120_000,
    hookTimeout: 120_000,
  },
});
