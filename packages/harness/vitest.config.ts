import { defineConfig } from 'vitest/config';

export default defineConfig({
  test: {
    name: 'harness',
    include: ['src/**/*.test.ts'],
    exclude: ['**/*.process.test.ts'],
  },
});
