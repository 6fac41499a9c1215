import { chmodSync, mkdirSync, readdirSync, statSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { temporaryFolder } from '@ubii/program/testing';
import { expect, it } from 'vitest';
import { DiskFolder, recordingPath, uploadPath, keepToOwner } from './disk-folder.ts';

const modeOf = (path: string): number => statSync(path).mode & 0o777;
const REJECTION = {
  reason: 'It is too large.',
  name: 'Walk',
  author: 'Ada',
  makerId: 'grant',
  rejectedMs: 5,
};

it.skipIf(process.platform === 'win32')(
  '[RC-46] recordings can be read by their owner alone',
  async () => {
    const path = join(temporaryFolder(), 'recordings');
    await (await new DiskFolder(path).create('a')).close();
    expect([modeOf(path), modeOf(recordingPath(path, 'a'))]).toEqual([0o700, 0o600]);
  },
);

it.skipIf(process.platform === 'win32')(
  '[RC-46] recordings of earlier versions are kept to their owner',
  async () => {
    const path = join(temporaryFolder(), 'recordings');
    mkdirSync(path, { mode: 0o755 });
    writeFileSync(recordingPath(path, 'a'), '');
    chmodSync(recordingPath(path, 'a'), 0o644);
    await keepToOwner(path);
    expect([modeOf(path), modeOf(recordingPath(path, 'a'))]).toEqual([0o700, 0o600]);
    await keepToOwner(join(path, 'missing'));
  },
);

it('[RC-45] keeps a rejected file with its reason, until it is deleted', async () => {
  const path = temporaryFolder();
  const folder = new DiskFolder(path);
  writeFileSync(recordingPath(path, 'a'), 'abc');
  writeFileSync(uploadPath(path, 'b'), 'abcd');
  const rejected = [
    await folder.reject('a', 'recording', REJECTION),
    await folder.reject('b', 'upload', REJECTION),
  ];
  expect(rejected.map(({ id, sizeBytes }) => [id, sizeBytes])).toEqual([
    ['a', 3],
    ['b', 4],
  ]);
  expect(await new DiskFolder(path).rejected()).toEqual(rejected);
  expect(await folder.list()).toEqual([]);
  await folder.delete('a');
  await folder.delete('b');
  expect(readdirSync(path)).toEqual([]);
});

it('[RC-45] lists a rejected file whose reason is lost', async () => {
  const path = temporaryFolder();
  writeFileSync(join(path, 'a.rejected'), 'abc');
  writeFileSync(join(path, 'a.rejected.json'), '{ "reason": 5');
  expect(await new DiskFolder(path).rejected()).toMatchObject([
    { id: 'a', rejection: { reason: 'It was refused by an earlier check.' } },
  ]);
});
