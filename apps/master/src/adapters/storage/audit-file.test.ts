import { appendFileSync, readdirSync, readFileSync, statSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { temporaryFolder } from '@ubii/program/testing';
import { afterAll, describe, expect, it } from 'vitest';
import { auditStoreSuite } from '../../testing/acceptance/index.ts';
import { RecordingLog } from '../../testing/index.ts';
import { AuditFile } from './audit-file.ts';

const newFolder = () => join(temporaryFolder(), 'audit');
const open = (folder: string, maxLines = 100, log = new RecordingLog()) =>
  new AuditFile({ folder, maxLines, log });

const shared = join(temporaryFolder(afterAll), 'audit');
auditStoreSuite('AuditFile', () => open(shared));

describe('an audit file', () => {
  it('is for the operator alone [EX-92]', async () => {
    const folder = newFolder();
    const store = open(folder);
    store.append('{}');
    await store.settled();
    expect(statSync(folder).mode & 0o777).toBe(0o700);
    expect(statSync(join(folder, 'audit.jsonl')).mode & 0o777).toBe(0o600);
  });

  it('keeps two files, however much is written [EX-92]', async () => {
    const folder = newFolder();
    const store = open(folder, 10);
    for (let i = 0; i < 95; i++) {
      store.append(`{"i":${i}}`);
      await store.settled();
    }
    expect(readdirSync(folder).sort()).toEqual(['audit.1.jsonl', 'audit.jsonl']);
    const lines = open(folder, 10).read();
    expect(lines.length).toBe(15);
    expect(lines.at(-1)).toBe('{"i":94}');
    expect(lines[0]).toBe('{"i":80}');
  });

  it('goes on behind a line that was cut off [EX-92]', async () => {
    const folder = newFolder();
    const first = open(folder);
    first.append('{"i":1}');
    await first.settled();
    appendFileSync(join(folder, 'audit.jsonl'), '{"i":');
    const next = open(folder);
    next.append('{"i":2}');
    await next.settled();
    expect(readFileSync(join(folder, 'audit.jsonl'), 'utf8')).toBe('{"i":1}\n{"i":\n{"i":2}\n');
  });

  it('says what it could not keep, and never throws [EX-92]', async () => {
    const folder = newFolder();
    writeFileSync(folder, 'a file, and no folder');
    const log = new RecordingLog();
    const store = open(folder, 100, log);
    store.append('{}');
    await store.settled();
    expect(log.lines.map(({ message }) => message)).toEqual([
      'the audit log cannot be kept',
      'entries of the audit log were not kept',
    ]);
  });
});
