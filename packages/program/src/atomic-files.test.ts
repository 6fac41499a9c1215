import { readdirSync, readFileSync, statSync, symlinkSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { describe, expect, it } from 'vitest';
import {
  createAtomicallySync,
  SECRET_MODE,
  writeAtomically,
  writeAtomicallySync,
} from './atomic-files.ts';
import { temporaryFolder } from './testing/index.ts';

/** Text of the only file in a folder. */
function onlyFile(folder: string): string {
  const names = readdirSync(folder);
  expect(names).toHaveLength(1);
  return readFileSync(join(folder, names[0]!), 'utf8');
}

const writers: readonly [string, typeof writeAtomically][] = [
  ['writeAtomically', writeAtomically],
  ['writeAtomicallySync', async (...given) => writeAtomicallySync(...given)],
];

describe.each(writers)('%s', (_, write) => {
  it('creates the folder, replaces the file and leaves nothing else', async () => {
    const folder = join(temporaryFolder(), 'a', 'b');
    await write(join(folder, 'file'), 'one');
    await write(join(folder, 'file'), 'two');
    expect(onlyFile(folder)).toBe('two');
  });

  it.skipIf(process.platform === 'win32')('keeps a secret from other users', async () => {
    const folder = join(temporaryFolder(), 'a', 'b');
    await write(join(folder, 'key'), 'secret', SECRET_MODE);
    expect(statSync(join(folder, 'key')).mode & 0o777).toBe(0o600);
    expect(statSync(join(folder, '..')).mode & 0o777).toBe(0o700);
  });

  it.skipIf(process.platform === 'win32')('replaces a link', async () => {
    const folder = temporaryFolder();
    const elsewhere = join(temporaryFolder(), 'elsewhere');
    writeFileSync(elsewhere, 'theirs');
    symlinkSync(elsewhere, join(folder, 'file'));
    await write(join(folder, 'file'), 'ours');
    expect(readFileSync(elsewhere, 'utf8')).toBe('theirs');
    expect(onlyFile(folder)).toBe('ours');
  });

  it('leaves nothing when it fails', async () => {
    const folder = temporaryFolder();
    await write(join(folder, 'file', 'in a folder'), '');
    await expect(write(join(folder, 'file'), 'text')).rejects.toThrow();
    expect(readdirSync(folder)).toEqual(['file']);
  });
});

it('createAtomicallySync leaves a file that exists as it is', () => {
  const folder = temporaryFolder();
  expect(createAtomicallySync(join(folder, 'key'), 'first', SECRET_MODE)).toBe(true);
  expect(createAtomicallySync(join(folder, 'key'), 'second', SECRET_MODE)).toBe(false);
  expect(onlyFile(folder)).toBe('first');
});
