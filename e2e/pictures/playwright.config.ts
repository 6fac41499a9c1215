import { defineConfig } from '@playwright/test';
import { LAUNCH_WITH_SENSORS } from '../fixtures/chromium.ts';
import stories from '../playwright.config.ts';

export default defineConfig({
  ...stories,
  testDir: '.',
  outputDir: '../test-results',
  workers: 1,
  retries: 0,
  reporter: 'list',
  projects: [{ name: 'pictures', use: { launchOptions: LAUNCH_WITH_SENSORS } }],
});
