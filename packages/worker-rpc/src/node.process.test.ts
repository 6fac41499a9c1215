import { mkdtempSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { pathToFileURL } from 'node:url';
import { expect, it, onTestFinished } from 'vitest';
import { openThread } from './node.ts';

interface Sleeper {
  sleep(): Promise<void>;
}

/** A thread of this code, and why it ended. */
function threadOf(code: string, workerData: unknown = {}) {
  const folder = mkdtempSync(join(tmpdir(), 'ubii-thread-'));
  onTestFinished(() => rmSync(folder, { recursive: true }));
  const path = join(folder, 'thread.mjs');
  writeFileSync(path, `import { parentPort } from 'node:worker_threads';\n${code}`);
  const ends: string[] = [];
  const thread = openThread<Sleeper>(
    {
      workerFile: pathToFileURL(path),
      name: 'test',
      workerData,
      heapMib: 32,
      onEnd: (reason) => void ends.push(reason),
      lost: (reason) => new Error(`Lost: ${reason}.`),
    },
    {},
  );
  onTestFinished(() => thread.end('the test ends'));
  return { thread, ends };
}

it('a thread that fails rejects what it was called for, and says so once', async () => {
  const { thread, ends } = threadOf(
    "parentPort.on('message', () => { throw new Error('full'); });",
  );
  await expect(thread.calls.sleep()).rejects.toThrow('Lost: full.');
  await expect(thread.calls.sleep()).rejects.toThrow('Lost: full.');
  expect(ends).toEqual(['full']);
});

it('a thread that exits is lost', async () => {
  const { thread, ends } = threadOf("parentPort.on('message', () => process.exit(1));");
  await expect(thread.calls.sleep()).rejects.toThrow('Lost: its thread ended.');
  expect(ends).toEqual(['its thread ended']);
});

it('a thread that cannot be started is lost', async () => {
  const { thread, ends } = threadOf('', { uncopied: () => undefined });
  await expect(thread.calls.sleep()).rejects.toThrow('could not be cloned');
  expect(ends).toHaveLength(1);
});

it('a thread that is ended says nothing', async () => {
  const { thread, ends } = threadOf("parentPort.on('message', () => undefined);");
  const asleep = thread.calls.sleep();
  const rejected = expect(asleep).rejects.toThrow('Lost: it is not needed.');
  await thread.end('it is not needed');
  await rejected;
  expect(ends).toEqual([]);
});
