import { existsSync } from 'node:fs';
import { chromium } from '@playwright/test';

const SYSTEM_CHROMIUM = '/usr/bin/chromium';
/** Start flags of measured browsers. */
export const CHROMIUM_FLAGS = [
  // The browser's own sandbox does not start as root.
  ...(process.getuid?.() === 0 ? ['--no-sandbox'] : []),
  ...(process.env['UBII_BENCH_GPU'] === '1' ? [] : ['--disable-gpu']),
  '--no-first-run',
  '--disable-background-networking',
  '--disable-component-update',
  '--disable-sync',
];

/** The browser to measure in: `UBII_CHROMIUM`, the system's, or Playwright's; undefined: there is none. */
export function findChromium(): string | undefined {
  const found = [process.env['UBII_CHROMIUM'], SYSTEM_CHROMIUM, chromium.executablePath()];
  return found.find((path) => path !== undefined && path !== '' && existsSync(path));
}
