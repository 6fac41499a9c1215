import { existsSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { pathToFileURL } from 'node:url';
import { DEFAULT_TEXT_LIMITS } from '@ubii/proto';
import { temporaryFolder } from '@ubii/program/testing';
import { FakeClock } from '@ubii/timing/testing';
import { expect, it, onTestFinished } from 'vitest';
import { ProcessChecker } from './process-checker.ts';

/** A checker whose process does this with a job. @param body of a function of `job` and `send` */
function checkerOf(body: string, start = "send({ kind: 'ready' });") {
  const folder = temporaryFolder();
  const path = join(folder, 'check-process.mjs');
  const code = `import { writeFileSync } from 'node:fs';
    const send = (message) => process.send(message);
    process.on('message', (job) => { ${body} });
    process.on('disconnect', () => process.exit());
    ${start}`;
  writeFileSync(path, code);
  const clock = new FakeClock();
  const limits = {
    ...DEFAULT_TEXT_LIMITS,
    recordingsBytes: 1e9,
    markersPerRecording: 100,
    recordingCheckMs: 20_000,
    recordingCheckBytes: 64 * 1024 * 1024,
  };
  const checker = new ProcessChecker({
    folder,
    clock,
    limits,
    processFile: pathToFileURL(path),
  });
  onTestFinished(() => checker.close());
  return { checker, clock };
}

const REFUSE = "send({ kind: 'verdict', verdict: { kind: 'refused', reason: job.id } });";

it('[RC-44] a file that ends the process of its check ends nothing else', async () => {
  const { checker } = checkerOf(`if (job.id === 'bad') process.exit(134); ${REFUSE}`);
  const [first, bad, last] = ['first', 'bad', 'last'].map((id) => checker.check({ id }));
  expect(await first).toEqual({ kind: 'refused', reason: 'first' });
  expect(await bad).toEqual({
    kind: 'unchecked',
    reason: 'Its check did not come to an end with 64 MiB of memory: it ended with code 134.',
  });
  expect(await last).toEqual({ kind: 'refused', reason: 'last' });
});

it('[RC-44] a file that takes too much memory ends its process', async () => {
  const { checker } = checkerOf('const kept = []; for (;;) kept.push({ kept: [kept.length] });');
  expect(await checker.check({ id: 'bad' })).toMatchObject({ kind: 'unchecked' });
});

it('[RC-44] a check that takes too long is ended', async () => {
  const seen = join(temporaryFolder(), 'seen');
  const { checker, clock } = checkerOf(`writeFileSync(${JSON.stringify(seen)}, '');`);
  const checked = checker.check({ id: 'bad' });
  await expect.poll(() => existsSync(seen)).toBe(true);
  clock.advanceSync(20_000);
  expect(await checked).toEqual({
    kind: 'unchecked',
    reason: 'Its check took longer than 20 s.',
  });
});

it('[RC-44] a process that cannot be started says nothing about files', async () => {
  const { checker } = checkerOf('', 'process.exit(1);');
  await expect(checker.check({ id: 'good' })).rejects.toMatchObject({ code: 'unavailable' });
});

it('[RC-44] a check that the end of the program interrupts says nothing about its file', async () => {
  const { checker } = checkerOf('', "send({ kind: 'ready' });");
  const checked = checker.check({ id: 'good' });
  await checker.close();
  await expect(checked).rejects.toMatchObject({ code: 'unavailable' });
});
