import { MuxIdentity, type Init, type TopicInputMapping, type TopicMux } from '@ubii/proto';
import type { RecordingEvent } from '@ubii/recording';
import { describe, expect, it } from 'vitest';
import type { TestClient, TestMaster } from '../src/testing/index.ts';
import { contentOf } from './recording-world.ts';
import {
  at,
  deviceEvent,
  list,
  masterWith,
  play,
  SESSION_ID,
  sessionEvent,
} from './replay-world.ts';

const RECORDED = [
  at('/ada/tilt', 0, 1, 'ada'),
  at('/ben/tilt', 100, 2, 'ben'),
  at('/ben/other', 150, 9, 'ben'),
  at('/ada/tilt', 200, 3, 'ada'),
];
const tilt = (topic: string) => [{ topic, name: 'tilt', tags: ['sensor'] }];
const DEVICES = [
  deviceEvent('phone-1', 'ada', tilt('/ada/tilt')),
  deviceEvent('phone-2', 'ben', tilt('/ben/tilt')),
];

/** A module that says which values it has, each with its identity. */
const sessionOf = (
  topicMux: Init<TopicMux>,
  more: readonly Init<TopicInputMapping>[] = [],
): RecordingEvent =>
  sessionEvent({
    name: 'watch',
    processingModules: [
      {
        id: 'one',
        name: 'watcher',
        processingMode: { triggerOnInput: {} },
        inputs: ['in', 'other'].map((internalName) => ({ internalName, messageFormat: 'double' })),
        outputs: [{ internalName: 'out', messageFormat: 'string' }],
        onProcessingStringified: `(deltaTime, inputs) => ({ outputs: { out: { string:
          inputs.in.elements.map(({ identity, double }) => identity + ' ' + double).join(', ') } } })`,
      },
    ],
    ioMappings: [
      {
        processingModuleId: 'one',
        inputMappings: [{ inputName: 'in', topicMux }, ...more],
        outputMappings: [{ outputName: 'out', topic: '/out' }],
      },
    ],
  });

/** Runs the session again. Returns what it wrote, and what the replay says of it. */
async function runAgain(
  mux: Init<TopicMux>,
  devices: readonly RecordingEvent[] = DEVICES,
  during: (master: TestMaster) => Promise<void> = () => Promise.resolve(),
) {
  const master = await masterWith(RECORDED, {}, [...devices, sessionOf(mux)]);
  const { session } = await play(master, { sessionId: SESSION_ID });
  await during(master);
  await master.pass(1_000);
  const { values } = await contentOf(master, session!.comparisonRecordingId);
  const outputs = values.filter(([topic]) => topic === `${session!.outputPrefix}/out`);
  return { outputs: outputs.map(([, value]) => value), problem: (await list(master))[0]!.problem };
}

describe('inputs of a session that runs again', () => {
  it('[RP-42] [RP-43] have the recorded components that they select, and their publishers', async () => {
    const { outputs, problem } = await runAgain({ component: { tags: ['sensor'] } });
    expect(outputs).toEqual(['ada 1', 'ada 1, ben 2', 'ada 3, ben 2']);
    expect(problem).toBe('');
  });

  it.each<[string, Init<TopicMux>, string]>([
    ['device', { identitySource: MuxIdentity.MUX_IDENTITY_DEVICE_ID }, 'phone-1 3, phone-2 2'],
    ['client', { identitySource: MuxIdentity.MUX_IDENTITY_CLIENT_ID }, 'ada 3, ben 2'],
    ['topic', { identitySource: MuxIdentity.MUX_IDENTITY_TOPIC }, '/ada/tilt 3, /ben/tilt 2'],
    ['pattern', { identityMatchPattern: '/(..).*/', identityGroup: 1 }, 'ad 3, be 2'],
  ])('[RP-43] have the recorded identity by %s', async (_, identity, last) => {
    const { outputs } = await runAgain({ component: { name: 'tilt' }, ...identity });
    expect(outputs.at(-1)).toBe(last);
  });

  it('[RP-43] have the recorded publishers also where topics are selected', async () => {
    const { outputs } = await runAgain({ topicGlob: '/*/tilt' }, []);
    expect(outputs.at(-1)).toBe('ada 3, ben 2');
  });

  it('[RP-42] have nothing of live components, and those nothing of theirs', async () => {
    let cara: TestClient | undefined;
    const { outputs } = await runAgain(
      { component: { tags: ['sensor'] } },
      DEVICES,
      async (master) => {
        cara = await master.extension('cara');
        await cara.subscribe({ subscribeComponents: [{ tags: ['sensor'] }, { name: 'tilt' }] });
        await cara.call({
          topic: '/services/device/registration',
          device: { name: 'live', clientId: cara.id, components: tilt('/live/tilt') },
        });
        cara.publish('/live/tilt', 'double', 7);
      },
    );
    expect(cara!.takeValues()).toEqual([['/live/tilt', 7]]);
    expect(outputs.at(-1)).toBe('ada 3, ben 2');
  });

  it.each<[string, RecordingEvent[], string]>([
    ['has no devices', [], 'the recording has no devices: in.'],
    [
      'has no component that fits',
      [deviceEvent('lamp', 'ada', [{ topic: '/lamp' }])],
      'no recorded component fits: in.',
    ],
  ])('[RP-42] stay empty, and are named, when the recording %s', async (_, devices, reason) => {
    const other = { inputName: 'other', topic: '/ben/other' };
    const session = sessionOf({ component: { tags: ['sensor'] } }, [other]);
    const master = await masterWith(RECORDED, {}, [...devices, session]);
    const { problem } = await play(master, { sessionId: SESSION_ID });
    expect(problem).toBe(`Inputs that select components stay empty, because ${reason}`);
  });
});
