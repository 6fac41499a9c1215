import { Re2Patterns } from '@ubii/patterns/re2';
import { createInlineSandboxes } from '@ubii/pm-sandbox/testing';
import { encodeRecord, fromJson, type RecordInit } from '@ubii/proto';
import { RecordingReader, type RecordingEvent } from '@ubii/recording';
import { recorded, recordedDevice } from '@ubii/recording/testing';
import { describe, expect, it } from 'vitest';
import { caseText, readCase } from '../../modules/cases/module-case.ts';
import { runCase } from '../../modules/cases/run-case.ts';
import { caseOfSpan, devicesOfSpan, moduleTopics } from './case-of-span.ts';

const START_NS = 1_750_000_000_000_000_000n;
const at = (ms: number, init: RecordInit) => {
  const logTimeNs = START_NS + BigInt(ms) * 1_000_000n;
  const record = encodeRecord(init);
  return { topic: init.topic, clientId: 'mara', record, logTimeNs, publishTimeNs: logTimeNs };
};
const PATTERNS = new Re2Patterns();
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
  const topics = moduleTopics(
    session,
    'm',
    { topics: reader.summary.topics, devices: [] },
    PATTERNS,
  );
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

describe('a test case of a module whose input selects components', () => {
  const watcher = fromJson('ubii.sessions.Session', {
    id: 's',
    processingModules: [
      {
        id: 'w',
        name: 'Watch',
        processingMode: { triggerOnInput: {} },
        inputs: [{ internalName: 'tilts', messageFormat: 'double' }],
        outputs: [{ internalName: 'out', messageFormat: 'string' }],
        onProcessingStringified: `(deltaTime, inputs) => ({ outputs: { out: { string:
          inputs.tilts.elements.map(({ identity, double }) => identity + ' ' + double).join() } } })`,
      },
    ],
    ioMappings: [
      {
        processingModuleId: 'w',
        inputMappings: [
          {
            inputName: 'tilts',
            topicMux: { component: { tags: ['tilt'] }, identitySource: 'MUX_IDENTITY_DEVICE_ID' },
          },
        ],
        outputMappings: [{ outputName: 'out', topic: '/out' }],
      },
    ],
  });
  const tilt = (id: string, timeMs: number): RecordingEvent<'device'> => ({
    kind: 'device',
    timeNs: START_NS + BigInt(timeMs) * 1_000_000n,
    value: recordedDevice(id, id, [
      { topic: `/${id}/tilt`, tags: ['tilt'] },
      { topic: `/${id}/other` },
    ]),
  });
  const RECORDS = [
    at(0, { topic: '/mara/tilt', format: 'double', value: 0 }),
    at(0, { topic: '/mara/other', format: 'double', value: 0 }),
    at(20, { topic: '/ben/tilt', format: 'double', value: 2 }),
    at(20, { topic: '/out', format: 'string', value: 'mara 0,ben 2' }),
    at(25, { topic: '/mara/other', format: 'double', value: 1 }),
    at(30, { topic: '/mara/tilt', format: 'double', value: 3 }),
    at(30, { topic: '/out', format: 'string', value: 'mara 3,ben 2' }),
    at(60, { topic: '/late/tilt', format: 'double', value: 6 }),
  ];

  it('has their records and devices, also as a file, and passes with them', async () => {
    const file = await recorded(RECORDS, [tilt('mara', 0), tilt('ben', 5), tilt('late', 50)]);
    const reader = await RecordingReader.open(file);
    const span = { fromMs: 10, untilMs: 40 };
    const known = {
      topics: reader.summary.topics,
      devices: await devicesOfSpan(reader, span),
    };
    const topics = moduleTopics(watcher, 'w', known, PATTERNS);
    expect(topics.inputs).toEqual([{ name: 'tilts', topics: ['/mara/tilt', '/ben/tilt'] }]);

    const watch = watcher.processingModules[0]!;
    const made = await caseOfSpan(reader, span, watcher, watch, topics);
    const read = readCase(caseText(made));
    expect(read).toEqual(made);
    expect(read.devices.map(({ id, components }) => [id, components.length])).toEqual([
      ['mara', 1],
      ['ben', 1],
    ]);
    const result = await runCase(read, watch, createInlineSandboxes(), PATTERNS);
    expect(result.fault).toBe(undefined);
    expect(result.topics).toMatchObject([{ topic: '/out', same: 2, missing: 0, additional: 0 }]);
    expect(result.isPassed).toBe(true);
  });
});
