import { chmodSync, statSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { temporaryFolder } from '@ubii/program/testing';
import { describe, expect, it } from 'vitest';

import { prepareDataDir } from './prepare-data-dir.ts';

describe('the data directory', () => {
  it('is made when it is missing, for its owner only', () => {
    const folder = join(temporaryFolder(), 'a', 'b');
    prepareDataDir(folder);
    expect(statSync(folder).isDirectory()).toBe(true);
    if (process.platform !== 'win32') expect(statSync(folder).mode & 0o077).toBe(0);
  });

  it('is refused when a file is in its place', () => {
    const file = join(temporaryFolder(), 'file');
    writeFileSync(file, '');
    expect(() => prepareDataDir(file)).toThrow(
      /\(--data-dir\) must be a folder .* a file has that name: choose another/,
    );
    expect(() => prepareDataDir(join(file, 'below'))).toThrow(/--data-dir/);
  });
});

it.skipIf(process.platform === 'win32')(
  '[RC-46] warns when other users may read the data directory',
  () => {
    const folder = temporaryFolder();
    const warnings: string[] = [];
    const log = { warn: (text: string) => void warnings.push(text) };
    chmodSync(folder, 0o700);
    prepareDataDir(folder, log);
    expect(warnings).toEqual([]);
    chmodSync(folder, 0o755);
    prepareDataDir(folder, log);
    expect(warnings).toEqual([expect.stringContaining(`chmod 700`)]);
  },
);
