import vue from '@vitejs/plugin-vue';
import { defineConfig } from 'vitest/config';

export default defineConfig({
  plugins: [vue()],
  test: {
    name: '@ubii/party',
    // Tests that need a DOM begin with `@vitest-environment happy-dom`.
    environment: 'node',
    include: ['src/**/*.test.ts'],
    exclude: ['**/*.process.test.ts'],
    // Modules that a test loads late take seconds on a busy machine; none waits for a time to pass.
    testTimeout: 60_000,
    expect: { poll: { timeout: 30_000 } },
  },
});
