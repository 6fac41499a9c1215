import { defineConfig } from 'vitest/config';

export default defineConfig({
  test: {
    name: 'pm-sandbox',
    include: ['src/**/*.test.ts', 'test/**/*.test.ts'],
    exclude: ['**/*.process.test.ts'],
    // Compiling modules takes seconds on a busy machine; none waits for a time to pass.
    testTimeout: 60_000,
    expect: { poll: { timeout: 30_000 } },
  },
});
