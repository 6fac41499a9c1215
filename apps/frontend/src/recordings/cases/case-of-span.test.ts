import { Re2Patterns } from '@ubii/patterns/re2';
import { encodeRecord, fromJson, type RecordInit } from '@ubii/proto';
import { RecordingReader } from '@ubii/recording';
import { recorded } from '@ubii/recording/testing';
import { describe, expect, it } from 'vitest';
import { caseOfSpan, moduleTopics } from './case-of-span.ts';

const START_NS = 1_750_000_000_000_000_000n;
const at = (ms: number, init: RecordInit) => {
  const logTimeNs = START_NS + BigInt(ms) * 1_000_000n;
  const record = encodeRecord(init);
  return { topic: init.topic, clientId: 'mara', record, logTimeNs, publishTimeNs: logTimeNs };
};
const session = fromJson('ubii.sessions.Session', {
  id: 's',
  processingModules: [{ id: 'm', name: 'Sum' }],
  ioMappings: [
    {
      processingModuleId: 'm',
      inputMappings: [
        { inputName: 'one', topic: '/a' },
        { inputName: 'all', topicMux: { id: 'x', topicGlob: '/phones/*' } },
      ],
      outputMappings: [{ outputName: 'sum', topic: '/sum' }],
    },
  ],
});
const module = session.processingModules[0]!;

async function make(untilMs = 30) {
  const times = [0, 10, 20, 30, 40];
  const file = await recorded(
    times.flatMap((ms) => [
      at(ms, { topic: '/a', format: 'double', value: ms }),
      at(ms, { topic: '/phones/1', format: 'bool', value: true }),
      at(ms, { topic: '/other', format: 'double', value: 1 }),
      at(ms, { topic: '/sum', format: 'double', value: ms + 1 }),
    ]),
  );
  const reader = await RecordingReader.open(file);
  const topics = moduleTopics(session, 'm', reader.summary.topics, new Re2Patterns());
  return {
    topics,
    theCase: await caseOfSpan(reader, { fromMs: 10, untilMs }, session, module, topics),
  };
}

describe('a test case of a span', () => {
  it('has what the module received and published, and what it knew before', async () => {
    const { topics, theCase } = await make();
    expect(topics.inputs.map((input) => input.topics)).toEqual([['/a'], ['/phones/1']]);
    const brief = (list: typeof theCase.inputs) =>
      list.map(({ atMs, topic, record }) => [atMs, topic, record]);
    expect(brief(theCase.before)).toEqual([
      [0, '/a', { double: 10 }],
      [0, '/phones/1', { bool: true }],
    ]);
    expect(brief(theCase.inputs)).toEqual([
      [10, '/a', { double: 20 }],
      [10, '/phones/1', { bool: true }],
      [20, '/a', { double: 30 }],
      [20, '/phones/1', { bool: true }],
    ]);
    expect(brief(theCase.outputs)).toEqual([
      [10, '/sum', { double: 21 }],
      [20, '/sum', { double: 31 }],
    ]);
    expect(theCase).toMatchObject({ durationMs: 20, module: { name: 'Sum' } });
    expect(theCase.mapping.processingModuleId).toBe('m');
  });
});
