import { defineConfig } from 'vitest/config';

export default defineConfig({
  test: {
    include: ['src/**/*.test.ts', 'test/**/*.test.ts'],
    exclude: ['**/*.process.test.ts'],
    // Tracking markers takes seconds on a busy machine; none waits for a time to pass.
    testTimeout: 60_000,
  },
});
