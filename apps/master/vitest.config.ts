import { defineConfig } from 'vitest/config';

export default defineConfig({
  test: {
    name: 'master',
    include: ['src/**/*.test.ts', 'test/**/*.test.ts'],
  },
});
