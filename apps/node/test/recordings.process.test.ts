import { createMemoryIdentity, createClient } from '@ubii/client-web/node';
import type { UbiiClient } from '@ubii/client-web/node';
import { RunningProgram, temporaryFolder } from '@ubii/program/testing';
import { readdirSync, readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { describe, expect, it, onTestFinished, vi } from 'vitest';
import { recordingsProgram, startMaster } from './programs.ts';

// Each test starts several programs, which takes long on a busy machine.
vi.setConfig({ testTimeout: 60_000 });

async function joinAs(url: string, name: string): Promise<UbiiClient> {
  const client = createClient({ url, name, identity: createMemoryIdentity() });
  onTestFinished(() => client.close());
  await client.connect();
  return client;
}

/** Runs a program of recordings to its end. @returns what it wrote to standard output */
async function run(...args: readonly string[]): Promise<string> {
  const program = new RunningProgram(recordingsProgram, args);
  expect(await program.ended(), program.stderr).toBe(0);
  return program.stdout;
}

/** A recording of three steps on `/lab/step` and a text. */
async function recordSteps(file: string): Promise<string> {
  const { url } = await startMaster();
  const publisher = await joinAs(url, 'Ada');
  const step = (number: number): void =>
    publisher.publish('/lab/step', 'vector2', { x: number, y: -number }, { immediate: true });
  publisher.publish('/elsewhere', 'double', 9);
  // The value that is there when the recording begins is part of it.
  step(1);
  const recorder = new RunningProgram(recordingsProgram, [
    ...['record', file, '--master', url, '--topics', '/lab/**', '--name', 'Three steps'],
    ...['--log-level', 'debug'],
  ]);
  await recorder.says('1 record of 1 topic');
  step(2);
  step(3);
  publisher.publish('/lab/word', 'string', 'done');
  await recorder.says('4 records of 2 topics');
  recorder.child.kill('SIGINT');
  expect(await recorder.ended(), recorder.stderr).toBe(0);
  expect(recorder.stderr).toContain('Stopped: 4 records of 2 topics');
  return url;
}

describe('the programs for recordings', () => {
  it('record what is chosen, describe it and export it', async () => {
    const folder = temporaryFolder();
    const file = join(folder, 'steps.mcap');
    await recordSteps(file);

    const summary = JSON.parse(await run('info', file, '--json')) as {
      name: string;
      topics: { topic: string; records: number; clientName: string }[];
    };
    expect(summary).toMatchObject({ name: 'Three steps', kind: 'recording', records: 4 });
    expect(
      summary.topics.map(({ topic, records, clientName }) => [topic, records, clientName]),
    ).toEqual([
      ['/lab/step', 3, 'Ada'],
      ['/lab/word', 1, 'Ada'],
    ]);
    expect(await run('info', file)).toMatch(/\/lab\/step {2}vector2 {2}3 .*Ada/);

    const tables = join(folder, 'tables');
    await run('export', file, '--out', tables);
    expect(readdirSync(tables).sort()).toEqual(['lab-step.csv', 'lab-word.csv']);
    const rows = readFileSync(join(tables, 'lab-step.csv'), 'utf8').trim().split('\r\n');
    expect(rows.map((row) => row.split(',').slice(4).join(','))).toEqual([
      'publisher,topic,format,x,y',
      'Ada,/lab/step,vector2,1,-1',
      'Ada,/lab/step,vector2,2,-2',
      'Ada,/lab/step,vector2,3,-3',
    ]);

    const again = new RunningProgram(recordingsProgram, ['export', file, '--out', tables]);
    expect(await again.ended()).toBe(1);
    expect(again.stderr).toContain('lab-step.csv cannot be written: it exists');
  });

  it('cut a part out, and import what was exported', async () => {
    const folder = temporaryFolder();
    const file = join(folder, 'steps.mcap');
    await recordSteps(file);
    const out = ['--out', join(folder, 'out')];
    await run('export', file, '--format', 'mcap', '--topics', '/lab/step', ...out);
    await run('export', file, '--topics', '/lab/step', ...out);
    const topics = async (path: string): Promise<unknown> =>
      (JSON.parse(await run('info', path, '--json')) as { topics: unknown }).topics;
    const step = { topic: '/lab/step', records: 3, clientName: 'Ada', format: 'vector2' };
    expect(await topics(join(folder, 'out/Three-steps.mcap'))).toMatchObject([step]);

    const table = join(folder, 'out/lab-step.csv');
    expect(await run('import', table, '--name', 'Again')).toContain('Imported 3 records.');
    expect(await topics(join(folder, 'out/lab-step.mcap'))).toMatchObject([step]);

    const late = new RunningProgram(recordingsProgram, [
      ...['export', file, '--format', 'mcap', '--from', '900', '--topics', '/none', ...out],
    ]);
    expect(await late.ended()).toBe(1);
    expect(late.stderr).toContain('has none of these topics');
  });

  it('replace personal data by rules, and keep the key apart', async () => {
    const folder = temporaryFolder();
    const file = join(folder, 'steps.mcap');
    await recordSteps(file);
    const rules = join(folder, 'rules.json');
    const word = { topicPattern: '/lab/word', treatment: 'PERSONAL_TREATMENT_DROP' };
    writeFileSync(rules, JSON.stringify({ labels: [word] }));
    const key = join(folder, 'key.json');
    const share = ['export', file, '--personal', rules, '--key', key];
    await run(...share, '--out', join(folder, 'a'));
    expect(readdirSync(join(folder, 'a'))).toEqual(['lab-step.csv']);
    const { pseudonyms } = JSON.parse(readFileSync(key, 'utf8')) as { pseudonyms: object };
    const ada = Object.entries(pseudonyms).find(([, original]) => original === 'Ada')![0];
    const table = readFileSync(join(folder, 'a/lab-step.csv'), 'utf8');
    expect(table).toContain(`${ada},/lab/step,vector2,1,-1`);
    expect(table).not.toContain('Ada');
    // The same key gives the same pseudonyms.
    await run(...share, '--out', join(folder, 'b'), '--format', 'mcap');
    const text = await run('info', join(folder, 'b/Shared-recording.mcap'), '--json');
    expect(JSON.parse(text)).toMatchObject({ topics: [{ topic: '/lab/step', clientName: ada }] });
    const broken = new RunningProgram(recordingsProgram, ['export', file, '--personal', file]);
    expect(await broken.ended()).toBe(1);
    expect(broken.stderr).toContain('The rules for personal data are no JSON object');
  });

  it('play a recording under other topics, with times of today', async () => {
    const file = join(temporaryFolder(), 'steps.mcap');
    const url = await recordSteps(file);
    const viewer = await joinAs(url, 'Viewer');
    const received: { x: number; isOfToday: boolean }[] = [];
    const subscription = viewer.subscribe('/replay/lab/step', { format: 'vector2' });
    subscription.onRecord(({ value, timestampMs }) =>
      received.push({ x: value.x, isOfToday: timestampMs! > before }),
    );
    await subscription.ready;
    const before = Date.now();
    await run('play', file, '--master', url, '--rename', '/=/replay', '--topics', '/lab/step');
    await expect.poll(() => received.map(({ x }) => x)).toEqual([1, 2, 3]);
    // The first was some seconds old when the recording began, and is that old again.
    expect(received.slice(1).map(({ isOfToday }) => isOfToday)).toEqual([true, true]);
    // Nothing is left of it when it has ended.
    await expect
      .poll(async () => (await viewer.call('topicList')).elements)
      .not.toContain('/replay/lab/step');
  });

  it('say what is wrong with a file', async () => {
    const folder = temporaryFolder();
    const text = join(folder, 'notes.txt');
    writeFileSync(text, 'no recording');
    for (const [path, words] of [
      [join(folder, 'none.mcap'), 'cannot be opened: it does not exist'],
      [text, 'cannot be read'],
    ] as const) {
      const program = new RunningProgram(recordingsProgram, ['info', path]);
      expect(await program.ended()).toBe(1);
      expect(program.stderr).toContain(words);
    }
  });
});
