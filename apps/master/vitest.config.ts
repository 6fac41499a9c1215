import { defineConfig } from 'vitest/config';

export default defineConfig({
  test: {
    name: 'master',
    include: ['src/**/*.test.ts', 'test/**/*.test.ts'],
    exclude: ['**/*.process.test.ts'],
    // Hundreds of arbitrary frames take seconds on a busy machine; none waits for a time to pass.
    testTimeout: 60_000,
    // A file takes seconds on a busy machine; the default is one.
    expect: { poll: { timeout: 30_000 } },
  },
});
