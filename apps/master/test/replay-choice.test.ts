import type { Init, ReplayStartRequest } from '@ubii/proto';
import { describe, expect, it } from 'vitest';
import { TestMaster } from '../src/testing/index.ts';
import { start as record, stop as stopRecording } from './recording-world.ts';
import { at, heard, ledger, list, listener, masterWith, play } from './replay-world.ts';

describe('what a replay plays', () => {
  it('[RP-12] [RP-13] plays what is selected, under the new names', async () => {
    const master = await masterWith([at('/x/a', 0, 1), at('/x/y/b', 0, 2), at('/z', 0, 3)]);
    const ada = await listener(master);
    const renames = [
      { fromPrefix: '/x', toPrefix: '/one' },
      { fromPrefix: '/x/y', toPrefix: '/two' },
    ];
    await play(master, { topics: ['/x/**'], renames, isPaused: true });
    expect(heard(ada)).toEqual([
      ['/one/a', 1],
      ['/two/b', 2],
    ]);
    await play(master, { excludedTopics: ['/x/**'], isPaused: true });
    expect(heard(ada)).toEqual([['/z', 3]]);
  });

  it.each<[string, Init<ReplayStartRequest>, string]>([
    ['topics that do not exist', { topics: ['/none'] }, 'invalid_argument'],
    [
      'a topic of the master',
      { renames: [{ fromPrefix: '/a', toPrefix: '/ubii/a' }] },
      'invalid_argument',
    ],
    [
      'one name for two topics',
      { renames: [{ fromPrefix: '/a', toPrefix: '/b' }] },
      'invalid_argument',
    ],
    ['a rate of 11', { rate: 11 }, 'invalid_argument'],
    ['a negative span', { span: { fromMs: 2, untilMs: 1 } }, 'invalid_argument'],
    ['a span beyond the end', { span: { fromMs: 2_000 } }, 'invalid_argument'],
    ['copies without a ghost', { copies: 2 }, 'invalid_argument'],
    ['a negative jitter', { isGhost: true, jitterMs: -1 }, 'invalid_argument'],
    ['too many copies', { isGhost: true, copies: 33 }, 'resource_exhausted'],
    ['an unknown recording', { recordingId: 'none' }, 'not_found'],
  ])('[RP-3] [RP-12] [RP-13] is refused with %s, and leaves nothing', async (_, request, code) => {
    const master = await masterWith();
    const before = await ledger(master);
    await expect(play(master, request)).rejects.toThrow(code);
    expect(await list(master)).toEqual([]);
    expect(await ledger(master)).toEqual(before);
  });

  it('[RP-3] [RP-4] is one of four, and alone on its topics', async () => {
    const master = await masterWith();
    await play(master);
    await expect(play(master)).rejects.toThrow(
      'failed_precondition: The replay "Replay of Tuesday"',
    );
    for (const toPrefix of ['/2', '/3', '/4']) {
      await play(master, { renames: [{ fromPrefix: '', toPrefix }] });
    }
    const fifth = play(master, { renames: [{ fromPrefix: '', toPrefix: '/5' }] });
    await expect(fifth).rejects.toThrow('resource_exhausted');
  });

  it('[RP-1] does not play a running recording', async () => {
    const master = new TestMaster();
    const recordingId = await record(master);
    await expect(play(master, { recordingId })).rejects.toThrow('failed_precondition');
    await stopRecording(master, recordingId);
  });
});
