import { execFileSync } from 'node:child_process';
import { expect, it } from 'vitest';

it('the source texts of the library are made from the definitions as they are [PM-64]', () => {
  // In a process of its own: the test runner compiles what it loads, and with it the texts.
  const script = `${import.meta.dirname}/../scripts/write-library.mjs`;
  expect(() =>
    execFileSync(process.execPath, [script, '--check'], { stdio: 'pipe' }),
  ).not.toThrow();
});
