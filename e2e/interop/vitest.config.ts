import { defineConfig } from 'vitest/config';

export default defineConfig({
  test: {
    name: 'interop',
    root: import.meta.dirname,
    include: ['tests/**/*.test.ts'],
    globalSetup: ['harness/global-setup.ts'],
    // Processes start and packages are installed here: what hangs is told from what is slow by minutes.
    testTimeout: 60_000,
    hookTimeout: 60_000,
    maxWorkers: 2,
    reporters: ['verbose'],
  },
});
