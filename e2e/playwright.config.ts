import { defineConfig } from '@playwright/test';
import { CHROMIUM_FLAGS, findChromium, findHeadlessShell } from './fixtures/chromium.ts';
import { findFirefox } from './fixtures/firefox.ts';

const isHeaded = process.argv.includes('--headed');
const firefox = findFirefox();

export default defineConfig({
  testDir: 'tests',
  outputDir: 'test-results',
  forbidOnly: process.env['CI'] === 'true',
  fullyParallel: true,
  // Each test starts a master and up to four pages; more than two at once starve each other.
  workers: 2,
  // One that passes the second time has found something, and is named at the end of the run; but in
  // continuous integration it does not hold up everything else.
  retries: process.env['CI'] === 'true' ? 1 : 0,
  // Deadlines cost nothing while all goes well, and a busy machine is ten times slower than an idle one.
  timeout: 180_000,
  expect: { timeout: 30_000, toPass: { timeout: 30_000 } },
  reporter: [['list'], ['html', { open: 'never', outputFolder: 'playwright-report' }]],
  use: {
    // Pictures of every frame would cost more than the pages themselves.
    trace: { mode: 'on-first-retry', screenshots: false, snapshots: true, sources: true },
    actionTimeout: 30_000,
    navigationTimeout: 60_000,
  },
  projects: [
    {
      name: 'chromium',
      use: {
        launchOptions: {
          executablePath: isHeaded ? findChromium() : findHeadlessShell(),
          args: [...CHROMIUM_FLAGS],
        },
      },
    },
    // Only where it is installed: what one browser allows and another does not shows in a few stories.
    ...(firefox === undefined
      ? []
      : [
          {
            name: 'firefox',
            grep: /@firefox/,
            use: {
              browserName: 'firefox' as const,
              // The system's own, by WebDriver BiDi
              channel: 'moz-firefox',
              launchOptions: { executablePath: firefox },
            },
          },
        ]),
  ],
});
