import { defineConfig } from 'vitest/config';

export default defineConfig({
  test: {
    name: 'node',
    globalSetup: ['test/build-programs.ts'],
    include: ['src/**/*.test.ts', 'test/**/*.test.ts'],
  },
});
