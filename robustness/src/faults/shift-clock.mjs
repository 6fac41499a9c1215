// Loaded into a master under test: on SIGUSR2 its wall clock takes the offset that a file says, in milliseconds.
// The file is in its own address: shift-clock.mjs?<path>. The monotonic clock stays as it is, as with a real jump.
import { readFileSync } from 'node:fs';

const file = decodeURIComponent(new URL(import.meta.url).search.slice(1));
const now = Date.now;
let offsetMs = 0;

Date.now = () => now() + offsetMs;
globalThis.Date = class extends Date {
  constructor(...args) {
    if (args.length === 0) super(now() + offsetMs);
    else super(...args);
  }
};

process.on('SIGUSR2', () => {
  offsetMs = Number(readFileSync(file, 'utf8'));
});
