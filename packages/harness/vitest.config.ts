import { defineConfig } from 'vitest/config';

export default defineConfig({
  test: {
    name: 'harness',
    include: ['src/**/*.test.ts'],
    // Several start processes, which takes seconds on a busy machine.
    testTimeout: 60_000,
  },
});
