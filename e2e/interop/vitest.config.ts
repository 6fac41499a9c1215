import { defineConfig } from 'vitest/config';

export default defineConfig({
  test: {
    name: 'interop',
    root: import.meta.dirname,
    include: ['tests/**/*.test.ts'],
    globalSetup: ['harness/global-setup.ts'],
    // Processes start and packages are installed here: what hangs is told from what is slow by minutes.
    testTimeout: 120_000,
    hookTimeout: 120_000,
    expect: { poll: { timeout: 30_000 } },
    maxWorkers: 2,
    reporters: ['verbose'],
  },
});
