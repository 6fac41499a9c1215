import { defineConfig } from 'vitest/config';

export default defineConfig({
  test: {
    name: 'bridge',
    globalSetup: ['test/build-programs.ts'],
    include: ['src/**/*.test.ts', 'test/**/*.test.ts'],
    // A process takes seconds on a busy machine; the default is one.
    expect: { poll: { timeout: 30_000 } },
  },
});
