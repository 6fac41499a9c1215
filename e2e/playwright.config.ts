import { defineConfig } from '@playwright/test';
import { CHROMIUM_FLAGS, findChromium } from './fixtures/chromium.ts';

export default defineConfig({
  testDir: 'tests',
  outputDir: 'test-results',
  forbidOnly: process.env['CI'] === 'true',
  fullyParallel: true,
  // Each test starts a master and up to four pages; more than two at once starve each other.
  workers: 2,
  // A test that passes the second time has found something.
  retries: 0,
  timeout: 60_000,
  expect: { timeout: 10_000 },
  reporter: [['list'], ['html', { open: 'never', outputFolder: 'playwright-report' }]],
  use: {
    trace: 'retain-on-failure',
    actionTimeout: 10_000,
    navigationTimeout: 20_000,
    launchOptions: { executablePath: findChromium(), args: [...CHROMIUM_FLAGS] },
  },
});
